#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "asset/read.hpp"
#include "support/error_of.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::asset {

/// A folder with files of models.
class Folder {
 public:
  /// Writes a file and returns its path.
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = folder_.path() / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  const std::filesystem::path& path() const { return folder_.path(); }

 private:
  test::TemporaryFolder folder_;
};

/// Returns a model that is read of a text as a file beside which there is nothing.
inline Model read_text(std::string_view text, Format format, const ReadOptions& options = {}) {
  return read_bytes(text, format, "/nowhere/model", options);
}

inline std::string message_of(std::string_view text, Format format,
                              const ReadOptions& options = {}) {
  return test::error_of([&] { read_text(text, format, options); }).what();
}

inline std::string all_notes(const Model& model) {
  std::string all;
  for (const std::string& note : model.notes) all += note + "\n";
  return all;
}

/// Tells whether a text holds another one.
inline testing::AssertionResult holds(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "\"" << text << "\" does not hold \"" << part << "\"";
}

inline const Primitive& first_of(const Model& model) {
  return model.meshes.at(0).primitives.at(0);
}

/// A PNG of 2 x 1 pixels: red, and green with an opacity of 0.
inline std::string png_2x1() {
  static constexpr unsigned char kBytes[] = {
      137, 80,  78, 71, 13,  10,  26,  10, 0,   0,   0,   13,  73, 72,  68,  82, 0,  0,
      0,   2,   0,  0,  0,   1,   8,   6,  0,   0,   0,   244, 34, 127, 138, 0,  0,  0,
      15,  73,  68, 65, 84,  120, 156, 99, 248, 207, 192, 240, 31, 8,   25,  0,  15, 249,
      2,   254, 45, 71, 129, 244, 0,   0,  0,   0,   73,  69,  78, 68,  174, 66, 96, 130};
  return {reinterpret_cast<const char*>(kBytes), sizeof(kBytes)};
}

}  // namespace aerostat::asset
