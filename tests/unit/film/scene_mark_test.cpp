// Tests which scenes count as the same on every machine.
#include "film/scene_mark.hpp"

#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "scene/scene.hpp"

namespace aerostat::film {
namespace {

namespace fs = std::filesystem;

class SceneMark : public testing::Test {
 protected:
  SceneMark() {
    fs::create_directories(folder_ / "here"), fs::create_directories(folder_ / "there");
  }
  ~SceneMark() override { fs::remove_all(folder_); }

  /// Writes a file of a size, and returns its name.
  std::string file(const std::string& name, std::size_t bytes) const {
    std::ofstream(folder_ / name) << std::string(bytes, 'x');
    return (folder_ / name).string();
  }

  const fs::path folder_ =
      fs::temp_directory_path() / ("aerostat-scene-mark-" + std::to_string(::getpid()));
};

/// A scene that names a file in each way.
scene::Scene scene_with(const std::string& file) {
  scene::Scene scene;
  scene.terrain.source = {file};
  scene.terrain.drape.file = file;
  scene.terrain.cover.source = file;
  scene.objects.resize(1);
  scene.objects[0].file = file;
  scene.balloon.track.emplace();
  scene.balloon.track->file = file;
  scene.balloon.artwork.resize(1);
  scene.balloon.artwork[0].file = file;
  scene.balloon.envelope.emplace();
  scene.balloon.envelope->file = file;
  scene.vegetation.species.resize(1);
  scene.vegetation.species[0].file = file;
  return scene;
}

TEST_F(SceneMark, CopiesOfFilesInOtherFoldersCountAsTheSame) {
  const std::string here = file("here/a.tif", 100), there = file("there/a.tif", 100);
  EXPECT_EQ(scene_checksum(scene_with(here)), scene_checksum(scene_with(there)));
  EXPECT_NE(scene_checksum(scene_with(here)), scene_checksum(scene_with(file("here/b.tif", 100))));
}

TEST_F(SceneMark, EachFileCountsByItsSize) {
  const std::string small = file("here/a.tif", 100), large = file("there/a.tif", 101);
  const scene::Scene scene = scene_with(small);
  const auto differs = [&](const scene::Scene& other) {
    return scene_checksum(other) != scene_checksum(scene);
  };
  scene::Scene other = scene;
  other.terrain.source = {large};
  EXPECT_TRUE(differs(other));
  other = scene;
  other.terrain.drape.file = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.terrain.cover.source = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.objects[0].file = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.balloon.track->file = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.balloon.artwork[0].file = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.balloon.envelope->file = large;
  EXPECT_TRUE(differs(other));
  other = scene;
  other.vegetation.species[0].file = large;
  EXPECT_TRUE(differs(other));
}

TEST_F(SceneMark, FoldersCountByTheFilesInThem) {
  for (const char* name : {"here/a.tif", "here/b.tif"}) file(name, 100);
  for (const char* name : {"there/b.tif", "there/a.tif"}) file(name, 100);
  scene::Scene here, there;
  here.terrain.source = {(folder_ / "here").string()};
  there.terrain.source = {(folder_ / "there").string()};
  EXPECT_EQ(scene_checksum(here), scene_checksum(there));
  file("there/b.tif", 99);
  EXPECT_NE(scene_checksum(here), scene_checksum(there));
}

TEST_F(SceneMark, MarksTellTheScene) {
  scene::Scene scene;
  const std::string mark = still_mark(scene);
  EXPECT_EQ(still_mark(scene), mark);
  scene.image.seed += 1;
  EXPECT_NE(still_mark(scene), mark);
}

}  // namespace
}  // namespace aerostat::film
