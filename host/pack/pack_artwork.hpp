#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "artwork/picture.hpp"
#include "core/math.hpp"
#include "pack/texels.hpp"
#include "scene/balloon.hpp"

namespace aerostat::scene {
struct Scene;
}

namespace aerostat::pack {

/// The most words that the pictures on all envelopes of a scene may take, with all their levels: 1
/// GiB.
inline constexpr std::size_t kMostArtworkWords = std::size_t{1} << 28;

/// A picture as the kernels read it (texture.h).
struct ArtworkTexture {
  std::vector<std::uint32_t> words;
  std::uint32_t width = 0, height = 0;
};

/// What decides on the words of a picture: its file, its size if it is a drawing, the number of
/// gores if each of them is drawn apart, and whether it goes on beyond its sides.
struct ArtworkKey {
  std::string file;
  artwork::DrawingSize size;
  int gores = 0;  // 0: the picture is taken as it is
  bool repeats = true;

  auto operator<=>(const ArtworkKey&) const = default;
};

/// Keeps the pictures on the envelopes of the last scene. It may be used from any thread.
class ArtworkCache {
 public:
  /// Returns a picture. Its file is read unless the last scene had the picture, too. What the
  /// reader has to say goes to the log. Throws the errors of artwork::read_picture().
  std::shared_ptr<const ArtworkTexture> picture(const ArtworkKey& key,
                                                const scene::Balloon& balloon);

  /// Ends the packing of a scene: pictures that were not asked for since the last call go.
  void finish();

  /// Returns these words, in the same memory as before if they are the same as before.
  std::shared_ptr<const std::vector<std::uint32_t>> layout(std::vector<std::uint32_t> words);

  /// Returns how many files were read.
  int files_read() const;

 private:
  mutable std::mutex mutex_;
  std::map<ArtworkKey, std::shared_ptr<const ArtworkTexture>> pictures_;
  std::set<ArtworkKey> asked_;
  std::shared_ptr<const std::vector<std::uint32_t>> layout_;
  int files_read_ = 0;
};

/// The pictures on the envelope of a balloon.
struct PackedArtwork {
  std::uint32_t place = 0;  // AeroBalloon::artwork; 0: no pictures
  /// The mean colour of the cloth over the envelope with its pictures, by area.
  dvec3 mean_cloth{1.0};
};

/// Packs the pictures on the envelopes of the balloons that are there, in their order, and appends
/// their words to the texels. Throws Error{exhausted} if they take more than kMostArtworkWords, and
/// what ArtworkCache::picture() throws, with the JSON pointer of the picture in front.
std::vector<PackedArtwork> pack_artwork(const scene::Scene& scene, ArtworkCache& cache,
                                        Texels& texels);

/// Returns a picture on the envelope of a balloon. Throws what ArtworkCache::picture() throws, with
/// the JSON pointer of the picture in front.
std::shared_ptr<const ArtworkTexture> artwork_texture(const scene::Artwork& artwork,
                                                      const scene::Balloon& balloon,
                                                      ArtworkCache& cache,
                                                      const std::string& pointer);

/// Returns the mean albedo of a balloon's palette.
dvec3 mean_palette(const scene::Balloon& balloon);

}  // namespace aerostat::pack
