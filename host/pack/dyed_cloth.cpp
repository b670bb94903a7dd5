#include "pack/dyed_cloth.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <oneapi/tbb/parallel_for.h>

#include "model/envelope_pattern.hpp"
#include "pack/artwork_layers.hpp"
#include "pack/mip_levels.hpp"
#include "pack/pack_artwork.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

/// The samples along each side of a texel, so that edges are smooth.
constexpr int kSamples = 2;

/// The cloth of one envelope with its pictures.
class Dyer {
 public:
  Dyer(const scene::Balloon& balloon, const std::string& pointer, ArtworkCache& cache)
      : cloth_(balloon), pattern_(balloon, cloth_.panels()) {
    for (std::size_t i = 0; i < balloon.artwork.size(); ++i) {
      const auto texture = artwork_texture(balloon.artwork[i], balloon, cache,
                                           fmt::format("{}/artwork/{}", pointer, i));
      layers_.push_back(artwork_layer(balloon.artwork[i], cloth_, texture->width, texture->height));
      pictures_.push_back(thumbnail_of(*texture, side_for(layers_.back(), *texture)));
    }
  }

  asset::Texture run() const {
    asset::Texture result{"cloth", kClothWidth, kClothHeight, {}};
    result.rgba.resize(std::size_t{4} * kClothWidth * kClothHeight);
    tbb::parallel_for(std::uint32_t{0}, kClothHeight, [&](std::uint32_t row) {
      std::uint8_t* texel = &result.rgba[std::size_t{4} * kClothWidth * row];
      for (std::uint32_t column = 0; column < kClothWidth; ++column, texel += 4) {
        const vec3 color = mean_at(column, row);
        for (int i = 0; i < 3; ++i) texel[i] = static_cast<std::uint8_t>(srgb_byte(color[i]));
        texel[3] = 255;
      }
    });
    return result;
  }

 private:
  /// Returns the most texels along a side of a picture, so that about two of them lie along each
  /// texel of the cloth.
  std::uint32_t side_for(const ArtworkLayer& layer, const ArtworkTexture& texture) const {
    const double around = layer.width > 0.0 ? layer.width / cloth_.widest_gore() : layer.period;
    const double wide = 2.0 * kClothWidth * around / cloth_.gores();
    const double tall = std::max(1.0, static_cast<double>(texture.height) / texture.width);
    return static_cast<std::uint32_t>(std::clamp(wide * tall, 1.0, 65536.0));
  }

  vec3 mean_at(std::uint32_t column, std::uint32_t row) const {
    vec3 sum(0.0f);
    for (int j = 0; j < kSamples; ++j) {
      for (int i = 0; i < kSamples; ++i) {
        const double u = (column + (i + 0.5) / kSamples) / kClothWidth;
        const double v = (row + (j + 0.5) / kSamples) / kClothHeight;
        sum += color_at(u * cloth_.gores(), (1.0 - v) * (cloth_.panels() + 1));
      }
    }
    return sum / static_cast<float>(kSamples * kSamples);
  }

  vec3 color_at(double gores_around, double panels_up) const {
    const vec3 fabric = fabric_at(gores_around, panels_up);
    const double sewn = std::min<double>(panels_up, cloth_.panels());
    const double height = sewn * cloth_.panel_height() + (panels_up - sewn) * cloth_.disc_length();
    return vec3(with_artwork(cloth_, dvec3(fabric), layers_, pictures_, {gores_around, height}));
  }

  vec3 fabric_at(double gores_around, double panels_up) const {
    if (panels_up >= cloth_.panels()) return pattern_.crown();
    const int gore = std::min(static_cast<int>(gores_around), cloth_.gores() - 1);
    const int band = pattern_.crosses_panels()
                         ? static_cast<int>(std::floor(pattern_.phase(gores_around, panels_up)))
                         : 0;
    return pattern_.fabric(gore, static_cast<int>(panels_up), band);
  }

  artwork::Unrolled cloth_;
  model::EnvelopePattern pattern_;
  std::vector<ArtworkLayer> layers_;
  std::vector<Thumbnail> pictures_;
};

}  // namespace

std::vector<asset::Texture> dyed_cloths(const scene::Scene& scene) {
  std::vector<asset::Texture> cloths;
  ArtworkCache cache;
  const auto add = [&](const scene::Balloon& balloon, const std::string& pointer) {
    if (!balloon.enabled) return;
    const bool is_plain = balloon.artwork.empty() || balloon.envelope;
    cloths.push_back(is_plain ? asset::Texture() : Dyer(balloon, pointer, cache).run());
  };
  add(scene.balloon, "/balloon");
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    add(scene.balloons[i], fmt::format("/balloons/{}", i));
  }
  return cloths;
}

}  // namespace aerostat::pack
