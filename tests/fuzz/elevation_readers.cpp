#include "elevation_readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <exception>
#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <zlib.h>

#include "core/error.hpp"
#include "elevation/asc.hpp"
#include "elevation/bil.hpp"
#include "elevation/bytes.hpp"
#include "elevation/dted.hpp"
#include "elevation/exr.hpp"
#include "elevation/open.hpp"
#include "elevation/png.hpp"
#include "elevation/raster.hpp"
#include "elevation/raw.hpp"
#include "elevation/side_files.hpp"
#include "elevation/usgs_dem.hpp"
#include "elevation/web_tile.hpp"
#include "elevation/zip.hpp"
#include "fuzz_file.hpp"
#include "geotiff_readers.hpp"
#include "land_readers.hpp"

namespace aerostat::test {
namespace {

using Bytes = std::span<const std::uint8_t>;

// A file of this many bytes is not unpacked any more.
constexpr std::uint64_t kMostUnpacked = std::uint64_t{1} << 20;

/// Reads the first and the last samples of a raster.
void read_some(const elevation::Raster& raster) {
  const elevation::RasterInfo& info = raster.info();
  if (info.width < 2 || info.height < 2) complain("the raster is too small");
  if (!info.georeference) complain("the raster has no place");
  if (!std::isfinite(info.georeference->per_column.x)) complain("the place is not finite");
  const int width = std::min(info.width, 512), height = std::min(info.height, 512);
  std::vector<float> heights(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  raster.read({0, 0, width, height}, heights.data());
  raster.read({info.width - width, info.height - height, width, height}, heights.data());
  for (const std::string& note : info.notes) {
    if (note.empty() || note.back() != '.') complain("a note is no sentence");
  }
}

std::shared_ptr<const elevation::ByteSource> source(Bytes bytes) {
  return elevation::memory_bytes({bytes.begin(), bytes.end()});
}

/// Says all that images need.
elevation::OpenOptions said() {
  elevation::OpenOptions options;
  options.image_heights_m = {0.0, 1000.0};
  options.cell_m = 10.0;
  return options;
}

/// Returns the text in front of the first zero byte, and the bytes behind it.
std::pair<std::string, Bytes> split(Bytes bytes) {
  const auto zero = std::find(bytes.begin(), bytes.end(), std::uint8_t{0});
  const auto length = static_cast<std::size_t>(zero - bytes.begin());
  return {std::string(bytes.begin(), zero),
          zero == bytes.end() ? Bytes() : bytes.subspan(length + 1)};
}

void read_bil(Bytes bytes) {
  elevation::SideFiles beside;
  const auto [hdr, samples] = split(bytes);
  beside.hdr = hdr;
  read_some(*elevation::read_bil(source(samples), beside, kPath, {}));
}

/// Makes the checksums of a PNG right, so that damage gets as far as the decoder.
std::vector<std::uint8_t> with_right_sums(Bytes bytes) {
  std::vector<std::uint8_t> copy(bytes.begin(), bytes.end());
  for (std::size_t at = 8; copy.size() >= 12 && at <= copy.size() - 12;) {
    const std::size_t length = std::size_t{copy[at]} << 24 | std::size_t{copy[at + 1]} << 16 |
                               std::size_t{copy[at + 2]} << 8 | copy[at + 3];
    if (length > copy.size() - at - 12) break;
    const auto sum = crc32(0, copy.data() + at + 4, static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      copy[at + 8 + length + i] = static_cast<std::uint8_t>(sum >> (24 - 8 * i));
    }
    at += length + 12;
  }
  return copy;
}

void read_png(Bytes damaged) {
  const std::vector<std::uint8_t> bytes = with_right_sums(damaged);
  try {
    read_some(*elevation::read_png(bytes, {}, kPath, {}));
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::bad_data) throw;
  }
  read_some(*elevation::read_png(bytes, {}, kPath, said()));
}

void read_raw(Bytes bytes) {
  elevation::OpenOptions options = said();
  if (bytes.size() > 2) {
    options.raw.width = bytes[0];
    options.raw.height = bytes[1];
    options.raw.header_bytes = bytes[2];
  }
  read_some(*elevation::read_raw(source(bytes), {}, kPath, options));
}

void read_packed(Bytes bytes) {
  if (!bytes.empty() && bytes[0] == 'P') {
    const auto member = elevation::unpack_zip(bytes, kPath, ".hgt", kMostUnpacked);
    if (member.bytes.size() > kMostUnpacked) complain("too much was unpacked");
  } else if (elevation::unpack_gzip(bytes, kPath, kMostUnpacked).size() > kMostUnpacked) {
    complain("too much was unpacked");
  }
}

void read_side_files(Bytes bytes) {
  const std::string text(bytes.begin(), bytes.end());
  std::vector<std::string> notes;
  elevation::crs_of_prj(text, notes);
  elevation::world_of(text);
  elevation::tile_number_of(text);
}

void read_asc(Bytes bytes) {
  // A file of more than 64 samples is not kept in memory here.
  read_some(*elevation::read_asc(source(bytes), {}, kPath, {}, 64));
}
void read_dted(Bytes bytes) {
  read_some(*elevation::read_dted(bytes, kPath, {}));
}
void read_exr(Bytes bytes) {
  read_some(*elevation::read_exr(bytes, {}, kPath, said()));
}
void read_usgs_dem(Bytes bytes) {
  read_some(*elevation::read_usgs_dem(bytes, kPath, {}));
}

// scripts/fuzz-elevation takes the names from here.
constexpr std::array kReaders{
    ElevationReader{"asc", read_asc},
    ElevationReader{"bil", read_bil},
    ElevationReader{"dted", read_dted},
    ElevationReader{"exr", read_exr},
    ElevationReader{"crs", read_crs, 60},
    ElevationReader{"geokeys", read_geokeys, 60},
    ElevationReader{"geotiff", read_geotiff, 20},
    ElevationReader{"packed", read_packed},
    ElevationReader{"picture", read_picture, 20},
    ElevationReader{"places", read_places},
    ElevationReader{"png", read_png},
    ElevationReader{"raw", read_raw},
    ElevationReader{"side_files", read_side_files},
    ElevationReader{"usgs_dem", read_usgs_dem},
};

}  // namespace

std::span<const ElevationReader> elevation_readers() {
  return kReaders;
}

std::string fault_of(const ElevationReader& reader, Bytes bytes) {
  try {
    reader.read(bytes);
  } catch (const Error& error) {
    const std::string message = error.what();
    if (error.kind() != ErrorKind::bad_data) return message;
    const bool names_file = message.starts_with(kPath.string() + ": ");
    return names_file ? "" : "a message without the file's name: " + message;
  } catch (const std::exception& error) {
    return std::string("not an error of aerostat's own: ") + error.what();
  }
  return "";
}

}  // namespace aerostat::test
