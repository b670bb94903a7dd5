#pragma once

#include <cstdint>
#include <vector>

#include "asset/model.hpp"

namespace aerostat::pack {

/// How the bytes of a texture count.
enum class TexelKind {
  color,         // red, green and blue are encoded in sRGB, and count in proportion to the opacity
  opaque_color,  // they are encoded in sRGB, and the opacity is 1 whatever the texture says
  data           // all four count as they are
};

/// Returns the byte of a linear value in sRGB (IEC 61966-2-1). Values beyond 0 to 1 are cut off.
std::uint32_t srgb_byte(float linear);

/// Returns a texture for the kernels: the header and all levels of texture.h. Each level is a mean
/// by area over the one before, of linear values. Throws Error{bad_data} for a texture of no size
/// or of more levels than the header has room for.
std::vector<std::uint32_t> texture_words(const asset::Texture& texture,
                                         const asset::TextureUse& use, TexelKind kind);

}  // namespace aerostat::pack
