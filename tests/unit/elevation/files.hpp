#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ios>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "elevation/open.hpp"
#include "elevation/raster.hpp"

/// Small files of heights for tests.
namespace aerostat::elevation {

/// A new folder that is removed at the end of the test.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "aerostat-XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline std::vector<float> heights_of(const Raster& raster) {
  const RasterInfo& info = raster.info();
  std::vector<float> heights(static_cast<std::size_t>(info.width) *
                             static_cast<std::size_t>(info.height));
  raster.read({0, 0, info.width, info.height}, heights.data());
  return heights;
}

inline float height_at(const Raster& raster, int column, int row) {
  float height = 0.0f;
  raster.read({column, row, 1, 1}, &height);
  return height;
}

/// Returns the coordinates of a sample's centre.
inline dvec2 centre_of(const Raster& raster, int column, int row) {
  const Georeference& place = raster.info().georeference.value();
  return place.origin + static_cast<double>(column) * place.per_column +
         static_cast<double>(row) * place.per_row;
}

/// Returns the message with which `action` refuses bad data, or what happened instead.
inline std::string refusal_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.kind() == ErrorKind::bad_data ? error.what()
                                               : std::string("another kind: ") + error.what();
  }
  return "nothing was refused";
}

inline bool has_note(const Raster& raster, std::string_view part) {
  for (const std::string& note : raster.info().notes) {
    if (note.find(part) != std::string::npos) return true;
  }
  return false;
}

/// Returns whether a message contains `part`.
inline testing::AssertionResult says(const std::string& message, std::string_view part) {
  if (message.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "it says: " << message;
}

}  // namespace aerostat::elevation
