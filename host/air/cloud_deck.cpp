#include "air/cloud_deck.hpp"

#include <algorithm>
#include <cmath>

#include "scene/scene.hpp"

namespace aerostat::air {
namespace {

/// The asymmetry of the droplets' phase function (kernels/device/atmosphere/droplets.clh).
constexpr double kAsymmetry = 0.87;
/// The share of light that droplets deflect widely. The rest still seems to come from the sun.
constexpr double kWideShare = 0.494;

/// The lowest cosine that hidden() tells apart. Chosen by eye.
constexpr double kLowest = 0.1;

/// Returns the mean height of clouds in heights of their layer. Closed decks are thicker than
/// single heaps. Chosen by eye, from densities that the kernels compute.
double mean_height(double cover) {
  return std::lerp(0.5, 0.9, cover);
}

}  // namespace

double CloudDeck::transmittance() const {
  return 1.0 / (1.0 + 0.75 * (1.0 - kAsymmetry) * depth);
}

double CloudDeck::sun_below(double sun_cosine) const {
  const double c = std::max(sun_cosine, kLowest);
  return 1.0 - hidden(c) * -std::expm1(-kWideShare * depth / c);
}

double CloudDeck::hidden(double cosine) const {
  // A heap about as high as wide hides twice its own area at 45 degrees.
  const double c = std::max(cosine, kLowest);
  return 1.0 - std::pow(1.0 - cover, 1.0 + std::sqrt(1.0 - std::min(c * c, 1.0)) / c);
}

dvec3 CloudDeck::light_below(const dvec3& ground_albedo) const {
  const double sent_back = cover * (1.0 - transmittance());
  return dvec3(1.0 - sent_back) / (1.0 - sent_back * ground_albedo);
}

CloudDeck cloud_deck_of(const scene::Scene& scene) {
  const scene::Cumulus& clouds = scene.sky.cumulus;
  CloudDeck deck;
  deck.cover = std::clamp(clouds.cover, 0.0, 1.0);
  deck.depth = kCloudExtinction * clouds.thickness_m * mean_height(deck.cover);
  deck.base = clouds.base_m;
  deck.top = clouds.base_m + clouds.thickness_m;
  return deck;
}

}  // namespace aerostat::air
