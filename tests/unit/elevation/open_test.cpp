#include "elevation/open.hpp"

#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/stat.h>

#include "core/error.hpp"
#include "files.hpp"

namespace aerostat::elevation {
namespace {

ErrorKind kind_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind();
  }
  return ErrorKind::internal;
}

TEST(Open, TheContentDecidesTheFormat) {
  const Folder folder;
  const std::string asc = "ncols 2\nnrows 2\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2\n3 4\n";
  EXPECT_EQ(open(folder.write("a.txt", asc))->info().format, "ESRI grid (.asc)");
  EXPECT_EQ(open(folder.write("a.hgt", asc))->info().format, "ESRI grid (.asc)");
}

TEST(Open, WhatIsNoFileOfHeightsIsRefused) {
  const Folder folder;
  EXPECT_EQ(kind_of([&] { open(folder.path() / "none.asc"); }), ErrorKind::io);
  EXPECT_EQ(kind_of([&] { open(folder.path()); }), ErrorKind::io);
  EXPECT_EQ(kind_of([&] { open(folder.write("a.txt", "hello")); }), ErrorKind::bad_data);
  EXPECT_EQ(kind_of([&] { open(folder.write("empty", "")); }), ErrorKind::bad_data);
  const auto pipe = folder.path() / "pipe.asc";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(kind_of([&] { open(pipe); }), ErrorKind::io);
}

TEST(Open, AFolderIsListedByName) {
  const Folder folder;
  for (const char* name : {"N46E010.hgt", "N46E009.HGT", "N46E008.hgt.gz", "b.tif", "preview.png",
                           "notes.txt", "a.prj", ".hidden.tif", "sub/c.tif"}) {
    folder.write(name, "x");
  }
  std::vector<std::string> names;
  for (const auto& path : elevation_files_in(folder.path())) names.push_back(path.filename());
  EXPECT_EQ(names,
            (std::vector<std::string>{"N46E008.hgt.gz", "N46E009.HGT", "N46E010.hgt", "b.tif"}));
}

TEST(Open, AFolderOfImagesAloneIsListed) {
  const Folder folder;
  folder.write("11_385_803.png", "x");
  EXPECT_EQ(elevation_files_in(folder.path()).size(), 1u);
}

TEST(Open, AFolderWithNothingOrTooMuchIsRefused) {
  const Folder folder;
  EXPECT_TRUE(says(refusal_of([&] { elevation_files_in(folder.path()); }), "no files of heights"));
  EXPECT_EQ(kind_of([&] { elevation_files_in(folder.path() / "none"); }), ErrorKind::io);
  for (int i = 0; i < 4097; ++i) folder.write(std::to_string(i) + ".asc", "");
  EXPECT_TRUE(says(refusal_of([&] { elevation_files_in(folder.path()); }), "more than 4096"));
}

}  // namespace
}  // namespace aerostat::elevation
