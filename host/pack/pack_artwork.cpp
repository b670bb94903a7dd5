#include "pack/pack_artwork.hpp"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "artwork/gores.hpp"
#include "artwork/unrolled.hpp"
#include "core/error.hpp"
#include "core/log.hpp"
#include "pack/artwork_layers.hpp"
#include "pack/mip_levels.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"

namespace aerostat::pack {
namespace {

using scene::ArtworkWrap;

/// The pixels of drawings. An envelope of 19 m is 59 m around, so that a pixel of a whole wrap is
/// 10 mm wide. Chosen by eye and by the memory that they take.
artwork::DrawingSize drawing_size(ArtworkWrap wrap) {
  switch (wrap) {
    case ArtworkWrap::whole:
    case ArtworkWrap::gores:
      return {6144, 3072, false};
    case ArtworkWrap::band:
      return {6144, 2048, true};
    case ArtworkWrap::motif:
      break;
  }
  return {4096, 4096, true};
}

ArtworkKey key_of(const scene::Artwork& artwork, const scene::Balloon& balloon) {
  const bool by_gores = artwork.wrap == ArtworkWrap::gores;
  return {artwork.file, drawing_size(artwork.wrap), by_gores ? balloon.gores : 0,
          artwork.wrap != ArtworkWrap::motif};
}

/// Packs the pictures of one balloon after the other.
class Packer {
 public:
  Packer(ArtworkCache& cache, Texels& texels) : cache_(cache), texels_(texels) {}

  /// Adds the pictures of a balloon. `pointer` is the balloon's in the scene.
  PackedArtwork add(const scene::Balloon& balloon, const std::string& pointer) {
    PackedArtwork packed{0, mean_palette(balloon)};
    if (balloon.artwork.empty()) return packed;
    const artwork::Unrolled cloth(balloon);
    const auto begin = static_cast<std::uint32_t>(words_.size());
    const std::vector<std::uint32_t> header = artwork_header(cloth, balloon.artwork.size());
    words_.insert(words_.end(), header.begin(), header.end());
    std::vector<ArtworkLayer> layers;
    std::vector<Thumbnail> pictures;
    for (std::size_t i = 0; i < balloon.artwork.size(); ++i) {
      const scene::Artwork& artwork = balloon.artwork[i];
      const auto texture =
          artwork_texture(artwork, balloon, cache_, fmt::format("{}/artwork/{}", pointer, i));
      layers.push_back(artwork_layer(artwork, cloth, texture->width, texture->height));
      pictures.push_back(thumbnail_of(*texture));
      append_layer(layers.back(), place_of(texture), words_);
    }
    packed.mean_cloth = mean_with_artwork(cloth, packed.mean_cloth, layers, pictures);
    packed.place = begin + 1;  // counts from the layout until that has a place
    return packed;
  }

  /// Appends the layout of all pictures, and gives the balloons their places in it.
  void finish(std::vector<PackedArtwork>& packed) {
    cache_.finish();
    if (words_.empty()) return;
    const auto layout = cache_.layout(std::move(words_));
    const std::uint32_t first = texels_.add(layout, *layout);
    for (PackedArtwork& one : packed) {
      if (one.place > 0) one.place += first - 1;
    }
  }

 private:
  /// Returns the place of a picture, which is there once for all that use it.
  std::uint32_t place_of(const std::shared_ptr<const ArtworkTexture>& texture) {
    const auto [entry, is_new] = places_.try_emplace(texture.get(), 0u);
    if (!is_new) return entry->second;
    taken_ += texture->words.size();
    if (taken_ > kMostArtworkWords) {
      throw Error(ErrorKind::exhausted,
                  fmt::format("the pictures on the envelopes take {} MiB, expected at most {}; "
                              "smaller or fewer pictures mend that",
                              taken_ >> 18, kMostArtworkWords >> 18));
    }
    entry->second = texels_.add(texture, texture->words);
    return entry->second;
  }

  ArtworkCache& cache_;
  Texels& texels_;
  std::vector<std::uint32_t> words_;
  std::map<const ArtworkTexture*, std::uint32_t> places_;
  std::size_t taken_ = 0;
};

}  // namespace

std::shared_ptr<const ArtworkTexture> ArtworkCache::picture(const ArtworkKey& key,
                                                            const scene::Balloon& balloon) {
  const std::lock_guard lock(mutex_);
  asked_.insert(key);
  std::shared_ptr<const ArtworkTexture>& kept = pictures_[key];
  if (kept) return kept;
  artwork::Picture read = artwork::read_picture(key.file, key.size);
  ++files_read_;
  const std::string name = std::filesystem::path(key.file).filename().string();
  for (const std::string& note : read.notes) warn(fmt::format("{}: {}", name, note));
  if (key.gores > 0) {
    read.texture = artwork::straightened(read.texture, artwork::Unrolled(balloon));
  }
  asset::TextureUse use;
  if (!key.repeats) use.wrap_u = asset::Wrap::clamp;
  use.wrap_v = asset::Wrap::clamp;
  auto made = std::make_shared<ArtworkTexture>();
  made->width = read.texture.width;
  made->height = read.texture.height;
  made->words = texture_words(read.texture, use, TexelKind::color);
  kept = std::move(made);
  return kept;
}

void ArtworkCache::finish() {
  const std::lock_guard lock(mutex_);
  std::erase_if(pictures_, [this](const auto& entry) { return !asked_.contains(entry.first); });
  asked_.clear();
}

std::shared_ptr<const std::vector<std::uint32_t>> ArtworkCache::layout(
    std::vector<std::uint32_t> words) {
  const std::lock_guard lock(mutex_);
  if (!layout_ || *layout_ != words) {
    layout_ = std::make_shared<const std::vector<std::uint32_t>>(std::move(words));
  }
  return layout_;
}

int ArtworkCache::files_read() const {
  const std::lock_guard lock(mutex_);
  return files_read_;
}

std::shared_ptr<const ArtworkTexture> artwork_texture(const scene::Artwork& artwork,
                                                      const scene::Balloon& balloon,
                                                      ArtworkCache& cache,
                                                      const std::string& pointer) {
  try {
    return cache.picture(key_of(artwork, balloon), balloon);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", pointer, error.what()));
  }
}

dvec3 mean_palette(const scene::Balloon& balloon) {
  dvec3 mean(0.0);
  for (const vec3& color : balloon.colors) mean += dvec3(glm::clamp(color, 0.0f, 1.0f));
  return mean / std::max<double>(1.0, static_cast<double>(balloon.colors.size()));
}

std::vector<PackedArtwork> pack_artwork(const scene::Scene& scene, ArtworkCache& cache,
                                        Texels& texels) {
  std::vector<PackedArtwork> packed;
  Packer packer(cache, texels);
  const auto add = [&](const scene::Balloon& balloon, const std::string& pointer) {
    if (balloon.enabled) packed.push_back(packer.add(balloon, pointer));
  };
  add(scene.balloon, "/balloon");
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    add(scene.balloons[i], fmt::format("/balloons/{}", i));
  }
  packer.finish(packed);
  return packed;
}

}  // namespace aerostat::pack
