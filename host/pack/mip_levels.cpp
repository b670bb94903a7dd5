#include "pack/mip_levels.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/math.hpp"
#include "texture.h"

namespace aerostat::pack {
namespace {

using glm::vec4;

/// A level in linear values. Colours are multiplied by the opacity.
struct Level {
  std::uint32_t width = 0, height = 0;
  std::vector<vec4> texels;
};

float linear_of(float encoded) {
  return encoded <= 0.04045f ? encoded / 12.92f : std::pow((encoded + 0.055f) / 1.055f, 2.4f);
}

float encoded_of(float linear) {
  return linear <= 0.0031308f ? linear * 12.92f : 1.055f * std::pow(linear, 1.0f / 2.4f) - 0.055f;
}

const std::array<float, 256>& linear_bytes() {
  static const std::array<float, 256> values = [] {
    std::array<float, 256> made{};
    for (std::size_t i = 0; i < made.size(); ++i) {
      made[i] = linear_of(static_cast<float>(i) / 255.0f);
    }
    return made;
  }();
  return values;
}

std::uint32_t byte_of(float value) {
  return static_cast<std::uint32_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
}

Level first_level(const asset::Texture& texture, TexelKind kind) {
  Level level{texture.width, texture.height, {}};
  level.texels.resize(std::size_t{texture.width} * texture.height);
  for (std::size_t i = 0; i < level.texels.size(); ++i) {
    const std::uint8_t* bytes = &texture.rgba[4 * i];
    const auto& linear = linear_bytes();
    vec4 even = vec4(bytes[0], bytes[1], bytes[2], bytes[3]) / 255.0f;
    if (kind == TexelKind::opaque_color) even.w = 1.0f;
    level.texels[i] =
        kind == TexelKind::data
            ? even
            : vec4(vec3(linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]) * even.w, even.w);
  }
  return level;
}

/// The texels of a level that a texel of the next one covers along an axis, with their shares.
struct Cover {
  std::uint32_t first = 0;
  std::array<float, 3> share{};
};

/// Returns what each of `to` texels covers of `from` ones, which are at most three times as many.
std::vector<Cover> covers(std::uint32_t from, std::uint32_t to) {
  std::vector<Cover> result(to);
  const double step = static_cast<double>(from) / to;
  for (std::uint32_t i = 0; i < to; ++i) {
    const double begin = step * i, end = begin + step;
    result[i].first = static_cast<std::uint32_t>(begin);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const double at = static_cast<double>(result[i].first) + k;
      const double part = std::min(end, at + 1.0) - std::max(begin, at);
      result[i].share[k] = static_cast<float>(std::max(part, 0.0) / step);
    }
  }
  return result;
}

Level next_level(const Level& from) {
  Level level{std::max(from.width / 2, 1u), std::max(from.height / 2, 1u), {}};
  const std::vector<Cover> columns = covers(from.width, level.width);
  const std::vector<Cover> rows = covers(from.height, level.height);
  for (const Cover& row : rows) {
    for (const Cover& column : columns) {
      vec4 sum(0.0f);
      for (std::uint32_t j = 0; j < 3; ++j) {
        for (std::uint32_t i = 0; i < 3; ++i) {
          const float share = row.share[j] * column.share[i];
          if (share <= 0.0f) continue;
          const std::size_t x = std::min(column.first + i, from.width - 1);
          const std::size_t y = std::min(row.first + j, from.height - 1);
          sum += share * from.texels[y * from.width + x];
        }
      }
      level.texels.push_back(sum);
    }
  }
  return level;
}

std::uint32_t word_of(const vec4& texel, TexelKind kind) {
  vec3 color(texel);
  if (kind != TexelKind::data) {
    if (texel.w > 0.0f) color /= texel.w;
    for (int i = 0; i < 3; ++i) color[i] = encoded_of(std::clamp(color[i], 0.0f, 1.0f));
  }
  return byte_of(color.x) | byte_of(color.y) << 8 | byte_of(color.z) << 16 | byte_of(texel.w) << 24;
}

/// Appends the texels of the first level, whose bytes are those of the texture. So what is
/// transparent keeps its colour.
void add_bytes(const asset::Texture& texture, TexelKind kind, std::vector<std::uint32_t>& words) {
  for (std::size_t i = 0; i < texture.rgba.size(); i += 4) {
    const std::uint8_t* bytes = &texture.rgba[i];
    const std::uint32_t opacity = kind == TexelKind::opaque_color ? 255u : bytes[3];
    words.push_back(bytes[0] | std::uint32_t{bytes[1]} << 8 | std::uint32_t{bytes[2]} << 16 |
                    opacity << 24);
  }
}

std::uint32_t number_of(asset::Wrap wrap) {
  switch (wrap) {
    case asset::Wrap::repeat:
      return AERO_WRAP_REPEAT;
    case asset::Wrap::mirror:
      return AERO_WRAP_MIRROR;
    case asset::Wrap::clamp:
      return AERO_WRAP_CLAMP;
  }
  return AERO_WRAP_REPEAT;
}

}  // namespace

std::uint32_t srgb_byte(float linear) {
  return byte_of(encoded_of(linear));
}

std::vector<std::uint32_t> texture_words(const asset::Texture& texture,
                                         const asset::TextureUse& use, TexelKind kind) {
  constexpr std::uint32_t kMostSide = 1u << (AERO_TEXTURE_MOST_LEVELS - 1);
  const std::uint32_t longest = std::max(texture.width, texture.height);
  if (std::min(texture.width, texture.height) == 0 || longest > kMostSide) {
    throw Error(ErrorKind::bad_data,
                fmt::format("{}: found a texture of {} x {} pixels, expected 1 to {} a side",
                            texture.name, texture.width, texture.height, kMostSide));
  }
  std::vector<std::uint32_t> words(AERO_TEXTURE_HEADER, 0);
  words[AERO_TEXTURE_WIDTH] = texture.width;
  words[AERO_TEXTURE_HEIGHT] = texture.height;
  words[AERO_TEXTURE_WRAP] =
      number_of(use.wrap_u) | number_of(use.wrap_v) << 8 | (use.nearest ? 1u << 16 : 0u);
  Level level = first_level(texture, kind);
  for (std::size_t i = 0;; ++i) {
    words[AERO_TEXTURE_PLACES + i] = static_cast<std::uint32_t>(words.size());
    words[AERO_TEXTURE_LEVELS] = static_cast<std::uint32_t>(i + 1);
    if (i == 0) {
      add_bytes(texture, kind, words);
    } else {
      for (const vec4& texel : level.texels) words.push_back(word_of(texel, kind));
    }
    if (level.width == 1 && level.height == 1) break;
    level = next_level(level);
  }
  return words;
}

}  // namespace aerostat::pack
