#include "model/envelope_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "core/error.hpp"
#include "model/shapes.hpp"

namespace aerostat::model {
namespace {

using scene::Pattern;

/// The height of one chevron in panels. Chosen by eye.
constexpr double kChevronPanels = 2.0;
/// The number of chevrons that a line climbs across one gore. Chosen by eye.
constexpr double kChevronRise = 1.25;
/// The turns of the spiral from the mouth to the disc. Chosen by eye.
constexpr double kSpiralTurns = 0.4;
/// The approximate width of one band of the spiral in gores. Chosen by eye.
constexpr int kSpiralGores = 2;
/// The plain panels at the mouth and at the disc, and the panels of a checker and of a rainbow
/// band. Chosen by eye.
constexpr int kPlainPanelsBelow = 2;
constexpr int kPlainPanelsAbove = 1;
constexpr int kCheckerPanels = 2;
constexpr int kRainbowPanels = 2;

double luminance(const vec3& color) {
  return glm::dot(color, vec3(0.2126f, 0.7152f, 0.0722f));
}

/// Returns element i of the sequence 0 1 2 1 0 1 ..., which has `half` steps up and `half` steps
/// down.
int zigzag(int i, int half) {
  const int place = i % (2 * half);
  return place <= half ? place : 2 * half - place;
}

/// Returns the largest number of steps up, at most four, with which a zigzag closes around all
/// gores. Returns 0 if there is none.
int zigzag_half(int gores) {
  for (const int half : {4, 3, 2, 1}) {
    if (gores % (2 * half) == 0) return half;
  }
  return 0;
}

int wrapped(int i, int count) {
  return ((i % count) + count) % count;
}

/// Returns the colour of the palette that differs most from the palette's mean, or a shade of the
/// only colour.
vec3 contrasting(const std::vector<vec3>& palette) {
  if (palette.size() == 1) {
    return luminance(palette[0]) > 0.2 ? palette[0] * 0.35f
                                       : glm::mix(palette[0], vec3(1.0f), 0.6f);
  }
  vec3 mean(0.0f);
  for (const vec3& color : palette) mean += color / static_cast<float>(palette.size());
  const auto distance = [&mean](const vec3& a, const vec3& b) {
    return glm::distance(a, mean) < glm::distance(b, mean);
  };
  return *std::max_element(palette.begin(), palette.end(), distance);
}

}  // namespace

EnvelopePattern::EnvelopePattern(const scene::Balloon& balloon, int panels)
    : pattern_(balloon.pattern), gores_(balloon.gores), panels_(panels), palette_(balloon.colors) {
  if (palette_.empty()) {
    throw Error(ErrorKind::bad_data, "balloon: no colours were found; at least one is needed");
  }
  vec3 mean(0.0f);
  for (vec3& color : palette_) {
    color = glm::clamp(color, 0.0f, 1.0f);
    mean += color / static_cast<float>(palette_.size());
  }
  trim_ = contrasting(palette_);
  const auto distance = [this](const vec3& a, const vec3& b) {
    return glm::distance(a, trim_) < glm::distance(b, trim_);
  };
  crown_ = *std::max_element(palette_.begin(), palette_.end(), distance);
  if (pattern_ == Pattern::stripes) crown_ = trim_;
  tape_ = mean * 0.3f;
}

bool EnvelopePattern::crosses_panels() const {
  return pattern_ == Pattern::chevrons || pattern_ == Pattern::spiral;
}

double EnvelopePattern::phase_per_turn() const {
  if (pattern_ != Pattern::spiral) return 0.0;
  const int colors = static_cast<int>(palette_.size());
  return colors * std::max(1, gores_ / (kSpiralGores * colors));
}

double EnvelopePattern::phase(double gores_around, double panels_up) const {
  if (pattern_ == Pattern::spiral) {
    return phase_per_turn() * (gores_around / gores_ + kSpiralTurns * panels_up / panels_);
  }
  // Neighbouring gores mirror each other. If the number of gores is odd, each gore has its own
  // point instead.
  const double period = gores_ % 2 == 0 ? 2.0 : 1.0;
  const double share = gores_around / period - std::floor(gores_around / period);
  const double climb = 1.0 - std::abs(2.0 * share - 1.0);
  return panels_up / kChevronPanels + kChevronRise * climb;
}

std::size_t EnvelopePattern::color_index(int gore, int panel, int band) const {
  const int colors = static_cast<int>(palette_.size());
  switch (pattern_) {
    case Pattern::stripes:
      return static_cast<std::size_t>(wrapped(gore, colors));
    case Pattern::checker: {
      const int along = gores_ % 2 == 0 ? gore / 2 : gore;
      return static_cast<std::size_t>(wrapped(along + panel / kCheckerPanels, colors));
    }
    case Pattern::rainbow: {
      const int half = zigzag_half(gores_);
      const int shift = half > 0 ? zigzag(gore, half) : 0;
      return static_cast<std::size_t>(wrapped((panel + shift) / kRainbowPanels, colors));
    }
    case Pattern::chevrons:
    case Pattern::spiral:
      break;
  }
  return static_cast<std::size_t>(wrapped(band, colors));
}

vec3 EnvelopePattern::fabric(int gore, int panel, int band) const {
  // No two bolts of cloth are dyed in exactly the same colour.
  const double shade = 0.95 + 0.05 * hash_unit(static_cast<std::uint32_t>(gore) + 1u,
                                               static_cast<std::uint32_t>(panel) + 1u);
  // Patterns that do not follow the gores end on plain cloth at the mouth and at the disc.
  const bool plain = panel < kPlainPanelsBelow || panel >= panels_ - kPlainPanelsAbove;
  const bool trimmed = plain && pattern_ != Pattern::stripes;
  const vec3 color = trimmed ? trim_ : palette_[color_index(gore, panel, band)];
  return color * static_cast<float>(shade);
}

vec3 EnvelopePattern::skirt() const {
  return crown_ * 0.8f;
}

}  // namespace aerostat::model
