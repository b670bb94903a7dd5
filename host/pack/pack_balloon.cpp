#include "pack/pack_balloon.hpp"

#include <algorithm>
#include <numbers>

#include "model/balloon.hpp"
#include "pack/copy.hpp"
#include "scene/balloons.hpp"

namespace aerostat::pack {
namespace {

/// Of both burners: some 40,000 candela, by the measure in which the sun's 128,000 lux are an
/// irradiance of 5. That makes an envelope at dusk as bright as photographs of it tell.
constexpr double kFlameIntensity = 1.6;
const dvec3 kFlameColor{1.0, 0.72, 0.38};

/// Mean albedo of the palette, by what the pattern shows of each.
dvec3 mean_cloth(const scene::Scene& scene, const scene::Balloon& balloon) {
  dvec3 mean(0.0);
  for (const vec3& color : balloon.colors) mean += dvec3(glm::clamp(color, 0.0f, 1.0f));
  mean /= std::max<double>(1.0, static_cast<double>(balloon.colors.size()));
  return mean * dvec3(scene.material(scene::MaterialId::envelope).albedo);
}

/// Returns the balloon that is nearest to the eye, whose cloth is seen best; null if there is none.
const scene::Balloon* seen_best(const scene::Scene& scene) {
  const auto balloons = scene::balloons_of(scene);
  const auto distance = [&scene](const scene::Balloon* balloon) {
    return glm::distance(balloon->position, *scene.camera.position);
  };
  const auto nearest = std::min_element(
      balloons.begin(), balloons.end(),
      [&](const scene::Balloon* a, const scene::Balloon* b) { return distance(a) < distance(b); });
  return nearest != balloons.end() ? *nearest : nullptr;
}

}  // namespace

AeroBalloon pack_balloon(const scene::Scene& scene) {
  AeroBalloon balloon{};
  const scene::Balloon* from = seen_best(scene);
  if (from == nullptr) return balloon;
  const scene::Material& cloth = scene.material(scene::MaterialId::envelope);
  const dvec3 color = mean_cloth(scene, *from);
  const dvec3 reflected = glm::min(color * cloth.diffuse, dvec3(0.95));
  const dvec3 kept = 1.0 / (1.0 - reflected);
  const dvec3 share = color * cloth.translucency * kept;
  copy(balloon.glow_sun, share * 0.25);
  copy(balloon.glow_sky, share);
  const dvec3 flame = kFlameColor * (from->burner * kFlameIntensity / std::numbers::pi);
  const double radius = 0.5 * from->diameter_m;
  copy(balloon.glow_flame, flame * reflected * kept / (radius * radius));
  copy(balloon.flame, model::flame_middle(*from) - scene.origin);
  copy(balloon.flame_light, flame);
  return balloon;
}

}  // namespace aerostat::pack
