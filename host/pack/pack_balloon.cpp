#include "pack/pack_balloon.hpp"

#include <algorithm>
#include <numbers>

#include "core/copy.hpp"
#include "model/balloon.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

/// Of both burners: some 40,000 candela, by the measure in which the sun's 128,000 lux are an
/// irradiance of 5. That makes an envelope at dusk as bright as photographs of it tell.
constexpr double kFlameIntensity = 1.6;
const dvec3 kFlameColor{1.0, 0.72, 0.38};

}  // namespace

AeroBalloon pack_balloon(const scene::ResolvedScene& scene, const scene::Balloon& from,
                         const PackedArtwork& artwork) {
  AeroBalloon balloon{};
  const scene::Material& cloth = scene->material(scene::MaterialId::envelope);
  const dvec3 color = artwork.mean_cloth * dvec3(cloth.albedo);
  const dvec3 reflected = glm::min(color * cloth.diffuse, dvec3(0.95));
  const dvec3 kept = 1.0 / (1.0 - reflected);
  const dvec3 share = color * cloth.translucency * kept;
  copy(balloon.glow_sun, share * 0.25);
  copy(balloon.glow_sky, share);
  const dvec3 flame = kFlameColor * (from.burner * kFlameIntensity / std::numbers::pi);
  const double radius = 0.5 * from.diameter_m;
  copy(balloon.glow_flame, flame * reflected * kept / (radius * radius));
  copy(balloon.flame, model::flame_middle(from) - scene.origin());
  copy(balloon.flame_light, flame);
  balloon.artwork = artwork.place;
  return balloon;
}

AeroBalloon pack_balloon(const scene::ResolvedScene& scene, const scene::Balloon& balloon) {
  return pack_balloon(scene, balloon, {0, mean_palette(balloon)});
}

}  // namespace aerostat::pack
