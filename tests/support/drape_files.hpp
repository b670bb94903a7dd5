#pragma once

#include <array>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "unit/elevation/png_file.hpp"

/// Files of pictures that are laid over land, for one test.
namespace aerostat::test {

/// Returns red, green, blue and opacity of a pixel, from 0 to 255.
using PixelAt = std::function<std::array<int, 4>(int column, int row)>;

/// A folder that lives as long as the object.
class DrapeFolder {
 public:
  DrapeFolder() {
    const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + test->name();
    for (char& c : name) c = c == '/' ? '-' : c;
    path_ = std::filesystem::temp_directory_path() / ("aerostat-drape-" + name);
    std::filesystem::create_directories(path_);
  }
  ~DrapeFolder() { std::filesystem::remove_all(path_); }
  DrapeFolder(const DrapeFolder&) = delete;
  DrapeFolder& operator=(const DrapeFolder&) = delete;

  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path_ / name, std::ios::binary) << text;
    return path_ / name;
  }

  /// Writes a PNG, and a world file that puts its north-west corner at (x, y).
  std::filesystem::path write_png(const std::string& name, int width, int height,
                                  const PixelAt& pixel_at, double x, double y, double cell) const {
    std::vector<int> values;
    for (int j = 0; j < height; ++j) {
      for (int i = 0; i < width; ++i) {
        for (const int value : pixel_at(i, j)) values.push_back(value);
      }
    }
    write(std::filesystem::path(name).replace_extension(".pgw").string(),
          std::to_string(cell) + "\n0\n0\n" + std::to_string(-cell) + "\n" +
              std::to_string(x + 0.5 * cell) + "\n" + std::to_string(y - 0.5 * cell) + "\n");
    return write(name, elevation::png(width, height, 8, 6, values));
  }

 private:
  std::filesystem::path path_;
};

}  // namespace aerostat::test
