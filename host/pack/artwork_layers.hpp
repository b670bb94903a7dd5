#pragma once

#include <cstdint>
#include <vector>

#include "artwork/unrolled.hpp"
#include "core/math.hpp"
#include "pack/pack_artwork.hpp"
#include "scene/artwork.hpp"

namespace aerostat::pack {

/// Where a picture lies on the cloth, in the units of artwork.h.
struct ArtworkLayer {
  double middle = 0.0, period = 1.0;  // gores
  double from = 0.0, to = 1.0;        // metres up the cloth
  double width = 0.0;                 // metres of a motif, else 0
};

/// Returns where a picture of `width` x `height` pixels lies. A motif keeps the proportions of its
/// pixels, and so does a band as nearly as whole copies allow.
ArtworkLayer artwork_layer(const scene::Artwork& artwork, const artwork::Unrolled& cloth,
                           std::uint32_t width, std::uint32_t height);

/// Returns the header of the pictures of an envelope with these numbers of layers, as artwork.h
/// says.
std::vector<std::uint32_t> artwork_header(const artwork::Unrolled& cloth, std::size_t layers);

/// Appends the words of a layer whose texture lies at a place.
void append_layer(const ArtworkLayer& layer, std::uint32_t texture,
                  std::vector<std::uint32_t>& words);

/// A picture of few pixels that stands for a large one: linear colours that are multiplied by the
/// opacity, row by row.
struct Thumbnail {
  std::uint32_t width = 1, height = 1;
  std::vector<glm::vec4> texels;
};
/// Returns the first level of detail whose sides have at most so many texels.
Thumbnail thumbnail_of(const ArtworkTexture& texture, std::uint32_t most_side = 64);

/// Returns a colour of the cloth with pictures over it. `place` counts gores around and metres up
/// the cloth.
dvec3 with_artwork(const artwork::Unrolled& cloth, const dvec3& cloth_color,
                   const std::vector<ArtworkLayer>& layers, const std::vector<Thumbnail>& pictures,
                   const dvec2& place);

/// Returns the mean colour of the cloth by area, with pictures over `cloth_color`.
dvec3 mean_with_artwork(const artwork::Unrolled& cloth, const dvec3& cloth_color,
                        const std::vector<ArtworkLayer>& layers,
                        const std::vector<Thumbnail>& pictures);

}  // namespace aerostat::pack
