#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "film/frames.hpp"
#include "render/session.hpp"

/// The options of the command line, one struct for each command. Ranges are already checked.
namespace aerostat::cli {

struct SceneOptions {
  std::filesystem::path scene;         // "-" stands for standard input
  std::vector<std::string> overrides;  // texts "/json/pointer=value"
  bool allow_external_paths = false;   // whether the scene file may name files outside its folder
  bool sandbox = false;                // whether the system keeps the process from other files
};

/// The devices that compute, and their limit of memory.
struct DeviceOptions {
  std::string selector;
  int lanes = 0;
  std::uint64_t memory_limit_bytes = 0;
  bool skip_self_test = false;
};

struct RenderOptions {
  SceneOptions input;
  // The value "-" stands for standard output. An empty value stands for the scene's name and .png
  // in the current folder.
  std::filesystem::path output;
  std::string format;   // "png", "exr" or "tif"; empty: chosen by the output's name
  std::string quality;  // empty: the scene's own quality
  std::optional<int> width, height, spp;
  std::optional<std::uint32_t> seed;
  std::optional<render::Crop> crop;
  std::optional<film::Shard> shard;  // a band of rows, for 'merge'
  double time_limit_s = 0.0;         // 0: none
  bool save_partial = false;         // of an interrupted render
  std::filesystem::path checkpoint;  // empty: none
  double checkpoint_every_s = 60.0;
  DeviceOptions device;
  std::filesystem::path labels;       // places to name in the picture; empty: none
  std::filesystem::path labels_json;  // "-" stands for standard output; empty: none
  bool world_file = false;
  bool denoise = false;
  bool quiet = false;
  bool stats = false;
};

struct ContactSheetOptions {
  SceneOptions input;
  // The value "-" stands for standard output. An empty value stands for the scene's name and
  // -seeds.png in the current folder.
  std::filesystem::path output;
  std::vector<std::uint32_t> seeds;  // seeds of the terrain, one for each tile
  int views = 0;                     // number of chosen views of real land; 0: seeds instead
  int columns = 0;                   // 0: chosen by the number of tiles
  int tile_width = 320;
  std::string quality;  // empty: the scene's own quality
  DeviceOptions device;
  bool quiet = false;
};

struct FilmOptions {
  SceneOptions input;
  // A film (.mp4, .mov, .mkv, .webm) or a pattern of frames such as frames/####.png. An empty value
  // stands for the scene's name and .mp4 in the current folder.
  std::filesystem::path output;
  film::FrameRange frames;
  film::Shard shard;
  std::string codec;    // empty: what suits the output
  std::string quality;  // empty: the scene's own quality
  std::optional<int> width, height;
  double time_limit_s = 0.0;  // 0: none
  bool preview = false;
  bool verify = false;
  DeviceOptions device;
  bool quiet = false;
};

struct MergeOptions {
  std::vector<std::filesystem::path> bands;
  std::filesystem::path output;  // a .png or .exr file
  bool quiet = false;
};

struct NewOptions {
  SceneOptions input;  // a file or folder of elevation data
  // The value "-" stands for standard output. An empty value stands for the file's name and .json
  // in the current folder.
  std::filesystem::path output;
  int view = 1;  // of the views by their measure, the best one being 1
};

struct ScenesOptions {
  bool folder = false;
};

struct DevicesOptions {
  bool json = false;
};

struct CheckOptions {
  SceneOptions input;  // or a track instead of a scene
  std::string device;  // whose memory is compared with what a render needs; empty: none
  bool json = false;
  std::filesystem::path land;  // elevation data below a track
};

struct DumpOptions {
  SceneOptions input;
  bool view = false;
};

struct ExportOptions {
  SceneOptions input;
  std::filesystem::path output;  // "-" stands for standard output
  std::string format;            // "ply", "obj", "glb" or "gltf"; empty: by the output's name
  std::string plants = "none";   // "none", "seen" or "all"
  std::uint64_t most_triangles = 20'000'000;
};

struct ArtworkOptions {
  SceneOptions input;            // an empty scene stands for all defaults
  std::filesystem::path output;  // "-" stands for standard output
  int balloon = 0;               // 0: /balloon; else the number in /balloons, from 1 on
  bool is_template = false;
};

}  // namespace aerostat::cli
