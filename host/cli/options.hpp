#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "render/session.hpp"

/// What the command line asks for, one struct a command. Ranges are already checked.
namespace aerostat::cli {

struct SceneOptions {
  std::filesystem::path scene;         // "-": standard input
  std::vector<std::string> overrides;  // "/json/pointer=value"
};

/// What computes, and with how much memory.
struct DeviceOptions {
  std::string selector;
  int lanes = 0;
  std::uint64_t memory_limit_bytes = 0;
};

struct RenderOptions {
  SceneOptions input;
  // "-": standard output; empty: the scene's name and .png in the current folder
  std::filesystem::path output;
  std::string format;   // "png" or "exr"; empty: as the output's name says
  std::string quality;  // empty: as the scene says
  std::optional<int> width, height, spp;
  std::optional<std::uint32_t> seed;
  std::optional<render::Crop> crop;
  DeviceOptions device;
  bool quiet = false;
  bool stats = false;
};

struct ContactSheetOptions {
  SceneOptions input;
  // "-": standard output; empty: the scene's name and -seeds.png in the current folder
  std::filesystem::path output;
  std::vector<std::uint32_t> seeds;  // of the terrain, one a tile
  int columns = 0;                   // 0: what suits
  int tile_width = 320;
  std::string quality;  // empty: as the scene says
  DeviceOptions device;
  bool quiet = false;
};

struct ScenesOptions {
  bool folder = false;
};

struct DevicesOptions {
  bool json = false;
};

struct ExportOptions {
  SceneOptions input;
  std::filesystem::path output;  // "-": standard output
  std::string format;            // "ply" or "obj"; empty: as the output's name says
  bool plants = false;
};

}  // namespace aerostat::cli
