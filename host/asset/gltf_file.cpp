#include "asset/gltf_file.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <fmt/format.h>

#include "asset/bytes.hpp"
#include "asset/words.hpp"
#include "track/text.hpp"

namespace aerostat::asset {
namespace {

constexpr std::size_t kHeaderBytes = 12;
constexpr std::size_t kChunkHeaderBytes = 8;
constexpr std::uint32_t kJsonChunk = 0x4e4f534a;
constexpr std::uint32_t kBinaryChunk = 0x004e4942;

// Parsing takes some four times the bytes of the text, and more for many small values.
constexpr std::size_t kMostJsonBytes = std::size_t{256} << 20;

// A value takes some 100 bytes of memory, so that these limits keep the JSON below half a GiB.
constexpr scene::detail::JsonRules kRules{
    .most_depth = 64, .most_values = 4'000'000, .with_comments = false};

constexpr std::array<std::string_view, 9> kRead = {"EXT_mesh_gpu_instancing",
                                                   "KHR_materials_emissive_strength",
                                                   "KHR_materials_ior",
                                                   "KHR_materials_pbrSpecularGlossiness",
                                                   "KHR_materials_transmission",
                                                   "KHR_materials_unlit",
                                                   "KHR_mesh_quantization",
                                                   "KHR_texture_transform",
                                                   "KHR_xmp_json_ld"};

/// Extensions that a file may require although they are ignored: the shape and the materials do not
/// depend on them.
constexpr std::array<std::string_view, 2> kDispensable = {"KHR_lights_punctual",
                                                          "KHR_materials_variants"};

/// The members of a document that must be arrays.
constexpr std::array<const char*, 13> kLists = {
    "accessors", "animations", "bufferViews", "buffers", "cameras", "images",  "materials",
    "meshes",    "nodes",      "samplers",    "scenes",  "skins",   "textures"};

/// Explanations of extensions, for messages.
struct Meaning {
  std::string_view extension, words;
};
constexpr std::array<Meaning, 5> kMeanings = {
    {{"KHR_draco_mesh_compression", "meshes compressed by Draco"},
     {"EXT_meshopt_compression", "buffers compressed by meshoptimizer"},
     {"KHR_meshopt_compression", "buffers compressed by meshoptimizer"},
     {"KHR_texture_basisu", "textures in KTX2"},
     {"EXT_texture_webp", "textures in WebP"}}};

bool is_among(std::span<const std::string_view> names, std::string_view extension) {
  return std::find(names.begin(), names.end(), extension) != names.end();
}

std::string in_words(std::string_view extension) {
  for (const Meaning& each : kMeanings) {
    if (each.extension == extension) return fmt::format(" ({})", each.words);
  }
  return {};
}

Json parse(std::string_view text) {
  if (text.size() > kMostJsonBytes) {
    refuse(
        fmt::format("found {} bytes of JSON, expected at most {}: larger buffers belong into a "
                    ".bin or a .glb",
                    text.size(), kMostJsonBytes));
  }
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (text.starts_with(kMark)) text.remove_prefix(kMark.size());
  return scene::detail::parse_json(text, "JSON", kRules);
}

/// Takes the next chunk of a .glb and moves behind it.
std::string_view take_chunk(std::string_view bytes, std::size_t& at, std::uint32_t& type) {
  if (bytes.size() - at < kChunkHeaderBytes) {
    refuse(fmt::format("byte {}: found the end of the file, expected a chunk", at));
  }
  const std::uint32_t length = little_at<std::uint32_t>(bytes, at);
  type = little_at<std::uint32_t>(bytes, at + 4);
  at += kChunkHeaderBytes;
  if (length > bytes.size() - at) {
    refuse(fmt::format("byte {}: found a chunk of {} bytes, but only {} are left", at, length,
                       bytes.size() - at));
  }
  const std::string_view chunk = bytes.substr(at, length);
  at += length;
  return chunk;
}

GltfFile open_glb(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes) refuse("the file ends inside of its header");
  const std::uint32_t version = little_at<std::uint32_t>(bytes, 4);
  const std::uint32_t length = little_at<std::uint32_t>(bytes, 8);
  if (version != 2) refuse(fmt::format("byte 4: found version {}, expected 2", version));
  if (length > bytes.size() || length < kHeaderBytes) {
    refuse(fmt::format("byte 8: found a length of {} bytes, but the file has {}", length,
                       bytes.size()));
  }
  bytes = bytes.substr(0, length);
  std::size_t at = kHeaderBytes;
  std::uint32_t type = 0;
  const std::string_view text = take_chunk(bytes, at, type);
  if (type != kJsonChunk) refuse("byte 16: found another chunk, expected one of JSON");
  GltfFile file{parse(text), std::nullopt};
  while (at < bytes.size()) {
    const std::string_view chunk = take_chunk(bytes, at, type);
    if (type == kBinaryChunk && !file.binary) file.binary = chunk;
  }
  return file;
}

}  // namespace

GltfFile open_gltf(std::string_view bytes) {
  if (bytes.starts_with("glTF")) return open_glb(bytes);
  return {parse(bytes), std::nullopt};
}

std::vector<std::string> check_gltf(const JsonValue& root) {
  const JsonValue asset = root["asset"];
  const std::string version = asset["version"].text();
  if (!version.starts_with("2.")) asset["version"].fail("version 2.0 of glTF");
  const std::string least = asset["minVersion"].text();
  if (!least.empty() && least != "2.0") asset["minVersion"].fail("version 2.0 of glTF");
  for (const char* list : kLists) root[list].size();  // which throws unless it is an array
  const JsonValue required = root["extensionsRequired"];
  for (std::size_t i = 0; i < required.size(); ++i) {
    const std::string extension = required.at(i).text();
    if (is_among(kRead, extension) || is_among(kDispensable, extension)) continue;
    required.at(i).fail(
        in_quotes(extension) + in_words(extension),
        fmt::format("only these extensions to be required: {}", fmt::join(kRead, ", ")));
  }
  std::vector<std::string> left_out;
  const JsonValue used = root["extensionsUsed"];
  for (std::size_t i = 0; i < used.size(); ++i) {
    const std::string extension = used.at(i).text();
    if (!is_among(kRead, extension)) {
      left_out.push_back(track::clean_text(extension) + in_words(extension));
    }
  }
  return left_out;
}

}  // namespace aerostat::asset
