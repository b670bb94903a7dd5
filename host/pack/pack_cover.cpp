#include "pack/pack_cover.hpp"

#include <cstddef>

#include "core/copy.hpp"
#include "core/land_cover.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

constexpr int number_of(CoverClass is) {
  return static_cast<int>(is);
}
static_assert(kGroundClasses == AERO_COVER_CLASSES);
static_assert(number_of(CoverClass::woods) == AERO_COVER_WOODS);
static_assert(number_of(CoverClass::shrub) == AERO_COVER_SHRUB);
static_assert(number_of(CoverClass::meadow) == AERO_COVER_MEADOW);
static_assert(number_of(CoverClass::crops) == AERO_COVER_CROPS);
static_assert(number_of(CoverClass::bare) == AERO_COVER_BARE);
static_assert(number_of(CoverClass::snow) == AERO_COVER_SNOW);
static_assert(number_of(CoverClass::built_up) == AERO_COVER_BUILT_UP);
static_assert(number_of(CoverClass::wetland) == AERO_COVER_WETLAND);

// The albedos of the classes, chosen by eye: of grass and shrubs where the biome's own ground is
// sand, of streets and roofs, and of wet ground with reeds.
constexpr vec3 kDryGrass{0.20f, 0.165f, 0.085f}, kDryShrub{0.115f, 0.105f, 0.06f};
constexpr vec3 kLeaves{0.05f, 0.065f, 0.028f};
constexpr vec3 kBuiltUp{0.21f, 0.2f, 0.19f}, kReeds{0.075f, 0.08f, 0.035f};

}  // namespace

AeroCover pack_cover(const scene::Scene& scene, const land::Cover& from, std::uint32_t first) {
  const land::NestedLevels& levels = from.ground();
  AeroCover cover{};
  cover.map.middle[0] = static_cast<float>(levels.middle.x);
  cover.map.middle[1] = static_cast<float>(levels.middle.y);
  cover.map.texel = static_cast<float>(levels.texel_m);
  cover.map.side = static_cast<std::uint32_t>(levels.side);
  cover.map.levels = static_cast<std::uint32_t>(levels.levels);
  cover.map.blend = 1.0f;
  cover.map.first = first;
  const scene::Ground& ground = scene.biome.ground;
  const bool sandy = scene.biome.kind == scene::BiomeKind::sand;
  const vec3 grass = sandy ? kDryGrass : 0.5f * (ground.cover_a + ground.cover_b);
  const vec3 rock = 0.5f * (ground.rock_a + ground.rock_b);
  const auto set = [&cover](CoverClass is, const vec3& albedo) {
    copy(cover.colors[static_cast<std::size_t>(is)], albedo);
  };
  set(CoverClass::woods, 0.5f * (grass + ground.forest));
  set(CoverClass::shrub, sandy ? kDryShrub : 0.5f * (grass + kLeaves));
  set(CoverClass::meadow, grass);
  set(CoverClass::crops, glm::mix(grass, ground.field, 0.4f));
  set(CoverClass::bare, rock);
  set(CoverClass::snow, ground.snow);
  set(CoverClass::built_up, kBuiltUp);
  set(CoverClass::wetland, kReeds);
  return cover;
}

}  // namespace aerostat::pack
