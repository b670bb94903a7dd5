#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>

#include "image/bands.hpp"
#include "image/exr_header.hpp"
#include "image/exr_layers.hpp"
#include "image/exr_streams.hpp"
#include "image/mark.hpp"

namespace aerostat::image {

namespace {

// Limits of a picture: its pixels along a side and for each byte of the file, and the bytes of the
// list of its channels. Deflate makes 1032 bytes of one, and a pixel of aerostat's has 60, so that
// no picture has more than 18.
constexpr std::int64_t kMostSide = 1 << 16, kMostPixelsOfByte = 64;
constexpr std::size_t kMostBytesOfChannels = 4096;

/// Returns whether a file can be a picture of the size that its header tells.
bool has_picture_size(std::span<const std::uint8_t> exr) {
  if (has_exr_parts(exr)) return false;
  std::int64_t pixels = 0;
  bool fits = true;
  const auto see = [&](std::string_view name, std::span<const std::uint8_t> content) {
    if (name == "channels") fits = fits && content.size() <= kMostBytesOfChannels;
    if ((name != "dataWindow" && name != "displayWindow") || content.size() != 16) return;
    const auto side = [&](std::size_t at) {
      const std::int64_t low = static_cast<std::int32_t>(exr_number(content, at));
      const std::int64_t high = static_cast<std::int32_t>(exr_number(content, at + 8));
      fits = fits && high >= low && high - low < kMostSide;
      return high - low + 1;
    };
    const std::int64_t width = side(0), height = side(4);
    if (fits && name == "dataWindow") pixels = width * height;
  };
  if (!each_exr_attribute(exr, see).name.empty()) return false;
  return fits && pixels > 0 && pixels <= kMostPixelsOfByte * static_cast<std::int64_t>(exr.size());
}

/// Decodes all pixels of a file, a row at a time, and keeps none.
void decode_rows(Imf::InputFile& file) {
  const Imath::Box2i& data = file.header().dataWindow();
  const auto width = static_cast<std::size_t>(std::int64_t{data.max.x} - data.min.x + 1);
  std::vector<std::vector<std::uint32_t>> rows;
  Imf::FrameBuffer frame;
  const Imf::ChannelList& channels = file.header().channels();
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    rows.emplace_back(width);
    // All rows go to the same memory: the stride from row to row is 0.
    constexpr std::size_t kStride = sizeof(std::uint32_t);
    char* const first = reinterpret_cast<char*>(rows.back().data());
    frame.insert(channel.name(),
                 Imf::Slice(channel.channel().type,
                            first - static_cast<std::ptrdiff_t>(kStride) * data.min.x, kStride, 0));
  }
  for (int y = data.min.y; y <= data.max.y; ++y) {
    file.setFrameBuffer(frame);
    file.readPixels(y);
  }
}

std::string mark_in(const Imf::Header& header) {
  const auto* const mark = header.findTypedAttribute<Imf::StringAttribute>(kExrMark);
  return mark == nullptr ? std::string() : mark->value();
}

/// Returns how the picture of a band is developed, or nothing if the file does not tell.
std::optional<Development> development_in(const Imf::Header& header) {
  const auto* const exposure = header.findTypedAttribute<Imf::DoubleAttribute>(kExrExposure);
  const auto* const white = header.findTypedAttribute<Imf::M33dAttribute>(kExrWhiteBalance);
  const auto* const vignette = header.findTypedAttribute<Imf::DoubleAttribute>(kExrVignette);
  if (exposure == nullptr || white == nullptr || vignette == nullptr) return std::nullopt;
  const auto* const glare = header.findTypedAttribute<Imf::DoubleAttribute>(kExrGlare);
  Development development{exposure->value(), {}, vignette->value(), 0.0};
  if (glare != nullptr) development.glare = std::clamp(glare->value(), 0.0, 1.0);
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) {
      development.white_balance[column][row] = white->value()[column][row];
    }
  }
  return development;
}

/// Returns a film without values that has the layers of a file.
Film film_for(const Imf::Header& header) {
  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  Film film;
  film.width = data.max.x - data.min.x + 1;
  film.height = data.max.y - data.min.y + 1;
  film.first = {data.min.x, data.min.y};
  film.whole = {display.max.x + 1, display.max.y + 1};
  const std::size_t pixels =
      static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  const auto resize = [&](const char* channel, auto& values) {
    if (header.channels().findChannel(channel) != nullptr) values.resize(pixels);
  };
  resize("R", film.radiance);
  resize("A", film.alpha);
  resize("Z", film.distance_m);
  resize("albedo.R", film.albedo);
  resize("N.X", film.normal_ws);
  resize("id", film.object_id);
  resize("samples", film.samples);
  return film;
}

/// Returns whether the window of a file lies in its picture, and its channels are those of the
/// layers of a film.
bool has_layers(const Imf::Header& header) {
  const Imath::Box2i &data = header.dataWindow(), &display = header.displayWindow();
  if (display.min != Imath::V2i(0) || data.min.x < 0 || data.min.y < 0 ||
      data.max.x > display.max.x || data.max.y > display.max.y) {
    return false;
  }
  Film one;
  one.radiance.resize(1);
  one.alpha.resize(1);
  one.distance_m.resize(1);
  one.albedo.resize(1);
  one.normal_ws.resize(1);
  one.object_id.resize(1);
  one.samples.resize(1);
  bool has_all = true;
  each_channel(one, [&](const char* name, Imf::PixelType type, const void*, std::size_t) {
    const Imf::Channel* const channel = header.channels().findChannel(name);
    has_all = has_all && channel != nullptr && channel->type == type && channel->xSampling == 1 &&
              channel->ySampling == 1;
  });
  return has_all;
}

}  // namespace

MarkedFile mark_of_exr(std::span<const std::uint8_t> exr) {
  MarkedFile marked;
  if (!has_picture_size(exr)) return marked;
  try {
    ExrInput stream(exr);
    Imf::InputFile file(stream);
    marked.mark = mark_in(file.header());
    decode_rows(file);
    marked.is_whole = true;
  } catch (const std::exception&) {
    // OpenEXR says by an exception that a file is damaged, and the caller needs no more than that.
    marked.is_whole = false;
  }
  return marked;
}

std::optional<Band> decode_band(std::span<const std::uint8_t> exr) {
  if (!has_picture_size(exr)) return std::nullopt;
  try {
    ExrInput stream(exr);
    Imf::InputFile file(stream);
    const auto development = development_in(file.header());
    if (!development || !has_layers(file.header())) return std::nullopt;
    Band band{film_for(file.header()), mark_in(file.header()), *development};
    file.setFrameBuffer(frame_of(band.film));
    file.readPixels(file.header().dataWindow().min.y, file.header().dataWindow().max.y);
    return band;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    return std::nullopt;  // damaged
  }
}

}  // namespace aerostat::image
