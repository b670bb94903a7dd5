#include "elevation/tiff_layout.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "elevation/open.hpp"

namespace aerostat::elevation {
namespace {

constexpr int kMostBands = 4096;

template <typename T>
T tag(TIFF* tiff, std::uint32_t number, T otherwise) {
  T value{};
  return TIFFGetFieldDefaulted(tiff, number, &value) != 0 ? value : otherwise;
}

/// Returns the type of samples, or nothing for those that are no real numbers of whole bytes.
std::optional<TiffSample> sample_of(int bits, int format, bool is_mask) {
  constexpr int kVoid = SAMPLEFORMAT_VOID;
  if (bits == 1 && is_mask) return TiffSample::bit;
  if (format == SAMPLEFORMAT_UINT || format == kVoid) {
    if (bits == 8) return TiffSample::uint8;
    if (bits == 16) return TiffSample::uint16;
    if (bits == 32) return TiffSample::uint32;
    if (bits == 64) return TiffSample::uint64;
  } else if (format == SAMPLEFORMAT_INT) {
    if (bits == 8) return TiffSample::int8;
    if (bits == 16) return TiffSample::int16;
    if (bits == 32) return TiffSample::int32;
    if (bits == 64) return TiffSample::int64;
  } else if (format == SAMPLEFORMAT_IEEEFP) {
    if (bits == 16) return TiffSample::float16;
    if (bits == 24) return TiffSample::float24;
    if (bits == 32) return TiffSample::float32;
    if (bits == 64) return TiffSample::float64;
  }
  return std::nullopt;
}

std::string name_of_codec(int compression) {
  constexpr std::array<std::pair<int, const char*>, 14> kNames{{{3, "CCITT Group 3"},
                                                                {4, "CCITT Group 4"},
                                                                {6, "old JPEG"},
                                                                {7, "JPEG"},
                                                                {34712, "JPEG 2000"},
                                                                {33003, "JPEG 2000"},
                                                                {33005, "JPEG 2000"},
                                                                {34887, "LERC"},
                                                                {34925, "LZMA"},
                                                                {50000, "ZSTD"},
                                                                {50001, "WebP"},
                                                                {50002, "JPEG XL"},
                                                                {52546, "JPEG XL"},
                                                                {34661, "JBIG"}}};
  for (const auto& [code, name] : kNames) {
    if (code == compression) return fmt::format("{} ({})", name, code);
  }
  return fmt::format("number {}", compression);
}

/// Sets the type of the samples. Returns false and sets `why` if it is not read.
bool set_sample(TIFF* tiff, TiffLayout& layout, std::string& why) {
  const int bits = tag<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
  const int format = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
  const auto sample = sample_of(bits, format, (layout.subfile & FILETYPE_MASK) != 0);
  if (sample) {
    layout.sample = *sample;
    return true;
  }
  const bool is_complex = format == SAMPLEFORMAT_COMPLEXINT || format == SAMPLEFORMAT_COMPLEXIEEEFP;
  why = is_complex ? "its samples are complex numbers, not heights"
                   : fmt::format("samples of {} bits ({}) are not read", bits,
                                 format == SAMPLEFORMAT_IEEEFP ? "floating point" : "integers");
  return false;
}

/// Returns the number of the band that tells what is transparent, or 0. The last bands of a file
/// are those with a meaning of their own.
int band_of_opacity(TIFF* tiff, int bands) {
  std::uint16_t count = 0;
  std::uint16_t* meanings = nullptr;
  if (TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &count, &meanings) == 0 || meanings == nullptr) {
    return 0;
  }
  for (int i = 0; i < count; ++i) {
    const int band = bands - count + i;
    const bool is_opacity =
        meanings[i] == EXTRASAMPLE_ASSOCALPHA || meanings[i] == EXTRASAMPLE_UNASSALPHA;
    if (is_opacity && band > 0 && band < bands) return band;
  }
  return 0;
}

/// Sets the sizes of strips or tiles. Returns whether they make sense.
bool set_blocks(TIFF* tiff, TiffLayout& layout) {
  layout.tiled = TIFFIsTiled(tiff) != 0;
  std::uint32_t width = static_cast<std::uint32_t>(layout.width), height = 0;
  if (layout.tiled) {
    width = tag<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0);
    height = tag<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0);
  } else {
    height = std::min(tag<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, ~0u),
                      static_cast<std::uint32_t>(layout.height));
  }
  if (width == 0 || height == 0 || width > kMostSamplesASide || height > kMostSamplesASide) {
    return false;
  }
  layout.block_width = static_cast<int>(width);
  layout.block_height = static_cast<int>(height);
  layout.block_bytes = layout.tiled ? TIFFTileSize64(tiff) : TIFFVStripSize64(tiff, height);
  const std::uint64_t row_bits = std::uint64_t{width} * bits_of(layout.sample) * layout.stride();
  return layout.block_bytes >= (row_bits + 7) / 8 * height;
}

}  // namespace

std::optional<TiffLayout> layout_of(const TiffHandle& handle, std::string& why) {
  TIFF* const tiff = handle.get();
  const std::uint32_t width = tag<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
  const std::uint32_t height = tag<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
  if (width == 0 || height == 0 || width > kMostSamplesASide || height > kMostSamplesASide ||
      std::uint64_t{width} * height > kMostSamples) {
    why = fmt::format("it has {} x {} samples; 1 to {} a side and at most {} are read", width,
                      height, kMostSamplesASide, kMostSamples);
    return std::nullopt;
  }
  TiffLayout layout;
  layout.width = static_cast<int>(width);
  layout.height = static_cast<int>(height);
  layout.subfile = tag<std::uint32_t>(tiff, TIFFTAG_SUBFILETYPE, 0);
  layout.bands = tag<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
  layout.bands_apart = tag<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, 1) == PLANARCONFIG_SEPARATE;
  layout.opacity = band_of_opacity(tiff, layout.bands);
  layout.compression = tag<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, 1);
  layout.photometric = tag<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
  if (layout.photometric == PHOTOMETRIC_YCBCR && layout.compression == COMPRESSION_JPEG) {
    // libtiff then decodes to red, green and blue, and the sizes of blocks are those of that.
    TIFFSetField(tiff, TIFFTAG_JPEGCOLORMODE, JPEGCOLORMODE_RGB);
  }
  if (layout.bands < 1 || layout.bands > kMostBands) {
    why = fmt::format("it has {} bands, and at most {} are read", layout.bands, kMostBands);
    return std::nullopt;
  }
  if (TIFFIsCODECConfigured(static_cast<std::uint16_t>(layout.compression)) == 0) {
    why = fmt::format(
        "it is compressed by {}, which the installed libtiff does not know; "
        "\"gdal_translate -co COMPRESS=DEFLATE\" makes a file that can be read",
        name_of_codec(layout.compression));
    return std::nullopt;
  }
  if (!set_sample(tiff, layout, why)) return std::nullopt;
  if (!set_blocks(tiff, layout) || layout.block_bytes > kMostBlockBytes ||
      std::uint64_t(layout.block_width) * layout.block_height > kMostBlockSamples) {
    why = fmt::format(
        "its {} are of {} x {} samples and {} bytes, and at most {} samples and {} bytes are read "
        "at once; \"gdal_translate -co TILED=YES\" makes a file that can be read",
        layout.tiled ? "tiles" : "strips", layout.block_width, layout.block_height,
        layout.block_bytes, kMostBlockSamples, kMostBlockBytes);
    return std::nullopt;
  }
  return layout;
}

std::string refusal_of_heights(const TiffLayout& layout) {
  switch (layout.photometric) {
    case PHOTOMETRIC_RGB:
    case PHOTOMETRIC_SEPARATED:
    case PHOTOMETRIC_YCBCR:
    case PHOTOMETRIC_CIELAB:
    case PHOTOMETRIC_ICCLAB:
    case PHOTOMETRIC_ITULAB:
    case PHOTOMETRIC_LOGLUV:
    case PHOTOMETRIC_LOGL:
      return "this is an image in colours, not heights";
    case PHOTOMETRIC_PALETTE:
      return "this is an image or a map of classes with a palette, not heights";
    default:
      return "";
  }
}

std::string refusal_of_codes(const TiffLayout& layout) {
  if (layout.photometric == PHOTOMETRIC_PALETTE) return "";
  return refusal_of_heights(layout).empty()
             ? ""
             : "this is an image in colours, whose codes of classes are not known";
}

}  // namespace aerostat::elevation
