#include "elevation/exr.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <limits>
#include <new>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <OpenEXR/IexBaseExc.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "elevation/bytes.hpp"
#include "elevation/images.hpp"
#include "elevation/reading.hpp"
#include "image/exr_header.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 31;

bool is_exr(Bytes head, const std::filesystem::path&) {
  return head.size() >= 4 && head[0] == 0x76 && head[1] == 0x2f && head[2] == 0x31 &&
         head[3] == 0x01;
}

std::unique_ptr<Raster> open_exr(const std::filesystem::path& path, const OpenOptions& options) {
  return read_exr(read_whole(path, kMostBytes), side_files_of(path), path, options);
}

/// Bytes in memory, as OpenEXR reads them.
class MemoryStream : public Imf::IStream {
 public:
  MemoryStream(Bytes bytes, const std::string& name) : Imf::IStream(name.c_str()), bytes_(bytes) {}

  bool read(char* to, int count) override {
    const auto length = static_cast<std::size_t>(count);
    if (count < 0 || at_ > bytes_.size() || bytes_.size() - at_ < length) {
      throw Iex::InputExc("the file is cut short");
    }
    std::memcpy(to, bytes_.data() + at_, length);
    at_ += length;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
};

/// Returns the name of the channel of heights.
std::string channel_of(const Imf::ChannelList& channels, const OpenOptions& options,
                       const std::filesystem::path& path) {
  std::string names;
  int count = 0;
  std::string only;
  for (auto i = channels.begin(); i != channels.end(); ++i) {
    only = i.name();
    if (++count <= 8) names += (names.empty() ? "" : ", ") + only.substr(0, 40);
  }
  if (!options.variable.empty()) {
    if (channels.findChannel(options.variable) != nullptr) return options.variable;
    refuse(path, fmt::format("the EXR file has the channels {}, and none named {}", names,
                             options.variable));
  }
  for (const char* name : {"Y", "R", "Z"}) {
    if (channels.findChannel(name) != nullptr) return name;
  }
  if (count == 1) return only;
  refuse(path, fmt::format("the EXR file has the channels {}; Y, R, Z or a single one is expected, "
                           "and /terrain/variable names another",
                           names.empty() ? "(none)" : names));
}

/// Sets the size of the image from the content of the header's attribute.
void set_size(RasterInfo& info, Bytes window, std::size_t file_bytes) {
  const auto side = [&](std::size_t at) {
    const std::int64_t low = static_cast<std::int32_t>(image::exr_number(window, at));
    const std::int64_t high = static_cast<std::int32_t>(image::exr_number(window, at + 8));
    return high < low ? 0 : static_cast<std::uint64_t>(high - low + 1);
  };
  const std::uint64_t width = side(0), height = side(4);
  require_size(info.path, width, height, false);
  // Deflate makes at most 1032 bytes of one, and a sample has two bytes at least.
  if (width * height > std::uint64_t{file_bytes} * 516) {
    refuse(info.path, fmt::format("the EXR file has {} bytes, too few for {} x {} samples",
                                  file_bytes, width, height));
  }
  info.width = static_cast<int>(width);
  info.height = static_cast<int>(height);
}

/// Checks the frame of the header. OpenEXR allocates as much memory as a file says that it needs.
void check_header(RasterInfo& info, Bytes bytes) {
  if (image::has_exr_parts(bytes)) {
    refuse(info.path, "the EXR file has several parts; one is expected");
  }
  const auto damaged = image::each_exr_attribute(bytes, [&](std::string_view name, Bytes content) {
    if (name == "dataWindow" && content.size() == 16) set_size(info, content, bytes.size());
  });
  if (!damaged.name.empty()) {
    refuse(info.path, fmt::format("the EXR file is damaged: {} in its header has {} bytes",
                                  std::string(damaged.name.substr(0, 40)), damaged.length));
  }
  if (info.width == 0) {
    refuse(info.path, "the EXR file is damaged: its header does not say the size of the image");
  }
}

std::vector<float> read_channel(Imf::InputFile& file, const RasterInfo& info,
                                const std::string& channel) {
  const auto& window = file.header().dataWindow();
  std::vector<float> stored(static_cast<std::size_t>(info.width) *
                            static_cast<std::size_t>(info.height));
  Imf::FrameBuffer frame;
  frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, stored.data(), window));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return stored;
}

/// Turns stored values into metres, and says how coarse the numbers of 16 bits are.
void to_metres(std::vector<float>& values, RasterInfo& info, const OpenOptions& options) {
  // Stored values are heights, unless the user gives the heights of 0 and 1.
  const HeightScale scale = height_scale_of(info, options, 0.0, 1.0, true);
  double largest = 0.0;
  for (float& value : values) {
    const auto stored = static_cast<double>(value);
    if (is_no_height(stored) || (options.nodata && is_mark(stored, *options.nodata))) {
      value = std::numeric_limits<float>::quiet_NaN();
      continue;
    }
    largest = std::max(largest, std::abs(stored));
    value = static_cast<float>(scale.scale * stored + scale.offset_m);
  }
  if (info.sample_type != "float16" || !(largest > 0.0)) return;
  // A number of 16 bits has 11 binary digits.
  const double step = std::exp2(std::floor(std::log2(largest)) - 10.0) * std::abs(scale.scale);
  info.notes.push_back(fmt::format(
      "The heights are numbers of 16 bits, so that the highest come in steps of {:.3g} m.", step));
}

std::unique_ptr<Raster> read_any(Bytes bytes, const SideFiles& beside, RasterInfo info,
                                 const OpenOptions& options) {
  check_header(info, bytes);
  MemoryStream stream(bytes, info.path.string());
  Imf::InputFile file(stream, 1);
  const auto& window = file.header().dataWindow();
  if (window.max.x - window.min.x + 1 != info.width ||
      window.max.y - window.min.y + 1 != info.height) {
    refuse(info.path, "the EXR file is damaged: it says two sizes of the image");
  }
  const std::string name = channel_of(file.header().channels(), options, info.path);
  const Imf::Channel& channel = *file.header().channels().findChannel(name);
  if (channel.xSampling != 1 || channel.ySampling != 1) {
    refuse(info.path, fmt::format("the channel {} of the EXR file leaves samples out", name));
  }
  info.sample_type = channel.type == Imf::HALF   ? "float16"
                     : channel.type == Imf::UINT ? "uint32"
                                                 : "float32";
  set_image_place(info, options, beside);
  std::vector<float> heights = read_channel(file, info, name);
  to_metres(heights, info, options);
  return std::make_unique<MemoryRaster>(std::move(info), std::move(heights));
}

}  // namespace

const Format kExrFormat{"EXR", is_exr, open_exr};

std::unique_ptr<Raster> read_exr(Bytes bytes, const SideFiles& beside,
                                 const std::filesystem::path& path, const OpenOptions& options) {
  RasterInfo info;
  info.path = path;
  info.format = "EXR image";
  try {
    return read_any(bytes, beside, std::move(info), options);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    refuse(path, fmt::format("the EXR file is damaged: {}", error.what()));
  }
}

}  // namespace aerostat::elevation
