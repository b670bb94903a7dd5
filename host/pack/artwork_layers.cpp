#include "pack/artwork_layers.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "artwork.h"
#include "texture.h"

namespace aerostat::pack {
namespace {

static_assert(AERO_MOST_ARTWORK == scene::kMostArtwork);
static_assert(AERO_ARTWORK_LAYERS == AERO_ARTWORK_WIDTHS + AERO_ARTWORK_WIDTH_COUNT);

/// The usual height of a band as a share of the cloth, and the usual width of a motif in diameters.
/// Chosen by eye.
constexpr double kBandShare = 0.2, kMotifWidth = 0.4;

std::uint32_t bits_of(double value) {
  return std::bit_cast<std::uint32_t>(static_cast<float>(value));
}

float linear_of(std::uint32_t byte) {
  const float encoded = static_cast<float>(byte & 255u) / 255.0f;
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

/// Returns the colour of a picture at u and v, multiplied by its opacity.
glm::vec4 color_at(const Thumbnail& picture, double u, double v) {
  const auto place = [](double share, std::uint32_t count) {
    const double at = std::floor(share * count);
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
  };
  return picture.texels[place(v, picture.height) * picture.width + place(u, picture.width)];
}

}  // namespace

ArtworkLayer artwork_layer(const scene::Artwork& artwork, const artwork::Unrolled& cloth,
                           std::uint32_t width, std::uint32_t height) {
  const double gores = cloth.gores();
  const double proportion = static_cast<double>(width) / height;
  ArtworkLayer layer;
  layer.middle = cloth.place_of(artwork.around_deg);
  layer.period = gores / artwork.repeat.value_or(1);
  layer.from = 0.0;
  layer.to = cloth.height();
  switch (artwork.wrap) {
    case scene::ArtworkWrap::whole:
      break;
    case scene::ArtworkWrap::gores:
      layer.middle = 0.5 * gores;
      break;
    case scene::ArtworkWrap::band: {
      const double half = 0.5 * kBandShare * cloth.height(), middle = cloth.widest_height();
      const dvec2 ends = artwork.heights_m.value_or(dvec2(middle - half, middle + half));
      layer.from = ends.x;
      layer.to = ends.y;
      if (artwork.repeat) break;
      const double around = gores * cloth.gore_width(0.5 * (ends.x + ends.y));
      const double copies = std::round(around / ((ends.y - ends.x) * proportion));
      layer.period = gores / std::clamp(copies, 1.0, 256.0);
      break;
    }
    case scene::ArtworkWrap::motif: {
      layer.width = artwork.width_m.value_or(kMotifWidth * cloth.diameter());
      const double middle = artwork.height_m.value_or(cloth.widest_height());
      layer.from = middle - 0.5 * layer.width / proportion;
      layer.to = middle + 0.5 * layer.width / proportion;
      break;
    }
  }
  return layer;
}

std::vector<std::uint32_t> artwork_header(const artwork::Unrolled& cloth, std::size_t layers) {
  std::vector<std::uint32_t> words(AERO_ARTWORK_LAYERS);
  words[AERO_ARTWORK_COUNT] = static_cast<std::uint32_t>(layers);
  words[AERO_ARTWORK_PANELS] = bits_of(cloth.panels());
  words[AERO_ARTWORK_PANEL] = bits_of(cloth.panel_height());
  words[AERO_ARTWORK_DISC] = bits_of(cloth.disc_length());
  const double step = cloth.height() / (AERO_ARTWORK_WIDTH_COUNT - 1);
  words[AERO_ARTWORK_STEP] = bits_of(step);
  for (std::size_t i = 0; i < AERO_ARTWORK_WIDTH_COUNT; ++i) {
    words[AERO_ARTWORK_WIDTHS + i] = bits_of(cloth.gore_width(step * static_cast<double>(i)));
  }
  return words;
}

void append_layer(const ArtworkLayer& layer, std::uint32_t texture,
                  std::vector<std::uint32_t>& words) {
  const std::size_t first = words.size();
  words.resize(first + AERO_ARTWORK_WORDS);
  words[first + AERO_ARTWORK_TEXTURE] = texture;
  words[first + AERO_ARTWORK_MIDDLE] = bits_of(layer.middle);
  words[first + AERO_ARTWORK_PERIOD] = bits_of(layer.period);
  words[first + AERO_ARTWORK_FROM] = bits_of(layer.from);
  words[first + AERO_ARTWORK_TO] = bits_of(layer.to);
  words[first + AERO_ARTWORK_WIDTH] = bits_of(layer.width);
}

Thumbnail thumbnail_of(const ArtworkTexture& texture, std::uint32_t most_side) {
  Thumbnail result;
  std::uint32_t level = 0;
  while (std::max(texture.width >> level, texture.height >> level) > most_side) ++level;
  result.width = std::max(texture.width >> level, 1u);
  result.height = std::max(texture.height >> level, 1u);
  const std::size_t first = texture.words[AERO_TEXTURE_PLACES + level];
  for (std::size_t i = 0; i < std::size_t{result.width} * result.height; ++i) {
    const std::uint32_t word = texture.words[first + i];
    const float opacity = static_cast<float>(word >> 24) / 255.0f;
    const vec3 color(linear_of(word), linear_of(word >> 8), linear_of(word >> 16));
    result.texels.emplace_back(color * opacity, opacity);
  }
  return result;
}

dvec3 with_artwork(const artwork::Unrolled& cloth, const dvec3& cloth_color,
                   const std::vector<ArtworkLayer>& layers, const std::vector<Thumbnail>& pictures,
                   const dvec2& place) {
  const double height = place.y;
  dvec3 color = cloth_color;
  for (std::size_t i = 0; i < layers.size(); ++i) {
    const ArtworkLayer& layer = layers[i];
    const double turned = place.x - layer.middle;
    const double around = turned - layer.period * std::floor(turned / layer.period + 0.5);
    const double beside =
        layer.width > 0.0 ? around * cloth.gore_width(height) / layer.width : around / layer.period;
    if (height < layer.from || height > layer.to || std::abs(beside) > 0.5) continue;
    const glm::vec4 seen =
        color_at(pictures[i], beside + 0.5, (layer.to - height) / (layer.to - layer.from));
    color = dvec3(vec3(seen)) + color * (1.0 - static_cast<double>(seen.w));
  }
  return color;
}

dvec3 mean_with_artwork(const artwork::Unrolled& cloth, const dvec3& cloth_color,
                        const std::vector<ArtworkLayer>& layers,
                        const std::vector<Thumbnail>& pictures) {
  constexpr int kRows = 64, kColumns = 128;
  dvec3 sum(0.0);
  double area = 0.0;
  for (int row = 0; row < kRows; ++row) {
    const double height = cloth.height() * (row + 0.5) / kRows;
    const double gore = cloth.gore_width(height);
    for (int column = 0; column < kColumns; ++column) {
      const double u = cloth.gores() * (column + 0.5) / kColumns;
      sum += gore * with_artwork(cloth, cloth_color, layers, pictures, {u, height});
      area += gore;
    }
  }
  return sum / area;
}

}  // namespace aerostat::pack
