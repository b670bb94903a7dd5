// Renders scenes in tiles of several sizes and tells whether the bits are the same. It is the
// program of scripts/check-bits. It prints a line for each picture: scene, size, lanes, pixels per
// tile (0 for the measured rate), a hash of the film, and "same" or the differences from the
// picture in the first tiles. It exits with 1 if any picture differs.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "pictures.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

struct Asked {
  std::string width, height;
  int lanes = 0;
  std::vector<int> tiles;
  std::vector<std::string> scenes;
};

std::vector<int> numbers(const std::string& list) {
  std::vector<int> values;
  std::istringstream in(list);
  for (std::string one; std::getline(in, one, ',');) values.push_back(std::stoi(one));
  return values;
}

scene::Scene standard_scene(const std::string& name, const Asked& asked) {
  return *world::resolve(scene::read_file(
      std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
      {{"/image/width", asked.width}, {"/image/height", asked.height}, {"/quality", "standard"}}));
}

/// Returns the FNV-1a hash of the radiance and the distances.
std::uint64_t hash_of(const image::Film& film) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::span<const std::byte> bytes) {
    for (const std::byte byte : bytes)
      hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3u;
  };
  add(std::as_bytes(std::span(film.radiance.data(), film.radiance.size())));
  add(std::as_bytes(std::span(film.distance_m.data(), film.distance_m.size())));
  return hash;
}

/// Returns "same", or the number of pixels that differ and the first few of them.
std::string difference(const image::Film& a, const image::Film& b) {
  std::string places;
  int count = 0;
  for (std::size_t i = 0; i < a.radiance.size(); ++i) {
    if (std::memcmp(&a.radiance[i], &b.radiance[i], sizeof(a.radiance[i])) == 0) continue;
    const auto width = static_cast<std::size_t>(a.width);
    if (++count <= 4) places += fmt::format(" {},{}", i % width, i / width);
  }
  if (count > 0) return fmt::format("{} pixels:{}", count, places);
  const auto same = same_bits(a, b);
  return same ? "same" : same.message();
}

bool print_table(const Asked& asked) {
  std::map<std::string, image::Film> first;
  bool all_same = true;
  for (const int tile : asked.tiles) {
    render::Options chosen = options(asked.lanes);
    chosen.tile_pixels = tile;
    chosen.use = render::Use::single_picture;
    render::Session session(chosen);
    for (const std::string& name : asked.scenes) {
      image::Film film = session.render(resolved(standard_scene(name, asked)));
      const std::uint64_t hash = hash_of(film);
      const auto [at, is_first] = first.try_emplace(name, std::move(film));
      const std::string verdict = is_first ? "same" : difference(at->second, film);
      all_same = all_same && verdict == "same";
      std::printf("%-16s %sx%s  %2d lanes  %6d  %016llx  %s\n", name.c_str(), asked.width.c_str(),
                  asked.height.c_str(), asked.lanes, tile, static_cast<unsigned long long>(hash),
                  verdict.c_str());
      std::fflush(stdout);
    }
  }
  return all_same;
}

}  // namespace
}  // namespace aerostat::test

int main(int argc, char** argv) {
  if (argc < 6) {
    std::fprintf(stderr, "usage: %s WIDTH HEIGHT LANES TILE,TILE... SCENE...\n", argv[0]);
    return 64;
  }
  try {
    const aerostat::test::Asked asked{argv[1],
                                      argv[2],
                                      std::atoi(argv[3]),
                                      aerostat::test::numbers(argv[4]),
                                      {argv + 5, argv + argc}};
    return aerostat::test::print_table(asked) ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", argv[0], error.what());
    return 70;
  }
}
