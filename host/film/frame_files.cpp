#include "film/frame_files.hpp"

#include <cerrno>
#include <cstddef>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include <fmt/format.h>

#include "core/checksum.hpp"
#include "core/error.hpp"
#include "film/exposure.hpp"
#include "film/program_mark.hpp"
#include "film/scene_mark.hpp"
#include "image/decode.hpp"
#include "image/mark.hpp"
#include "opencl/program.hpp"
#include "scene/scene.hpp"

namespace aerostat::film {
FrameMarks::FrameMarks(Timeline& timeline, FrameFormat format)
    : timeline_(timeline), format_(format), program_(program_mark(opencl::kernel_sources())) {}

std::uint64_t FrameMarks::checksum_of(int moment) {
  const auto known = moments_.find(moment);
  if (known != moments_.end()) return known->second;
  const std::uint64_t sum =
      scene_checksum(timeline_.scene_at_time(meter_time(timeline_.film(), moment)));
  moments_.emplace(moment, sum);
  return sum;
}

std::string FrameMarks::mark_of(int frame) {
  const scene::Scene scene = timeline_.scene_at(frame);
  std::string from = fmt::format("{:016x}", scene_checksum(scene));
  for (int i = 0; timeline_.moments() > 1 && i < timeline_.moments(); ++i) {
    const double time = timeline_.time_of_moment(frame, i);
    from += fmt::format("+{:016x}", scene_checksum(timeline_.scene_at_time(time)));
  }
  // Files of linear light are not exposed.
  if (format_ == FrameFormat::png && !scene.image.exposure_ev) {
    const MeterSpan span = meter_span(timeline_.film(), timeline_.time_of(frame));
    from += fmt::format("-{:016x}", checksum_of(span.from));
    if (span.share > 0.0) {
      from += fmt::format("-{:016x}-{}", checksum_of(span.from + 1), span.share);
    }
  }
  return fmt::format("{} {:016x}", program_, checksum(from));
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& file) {
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream),
                                  std::istreambuf_iterator<char>()};
  if (!stream.is_open() || stream.bad()) {
    throw Error(ErrorKind::io,
                fmt::format("cannot read '{}': {}", file.string(), std::strerror(errno)));
  }
  return bytes;
}

image::Pixels pixels_of(const std::filesystem::path& file) {
  constexpr int kRgb = 3;
  const auto image = image::decode_8_bits(bytes_of(file), image::Channels::own, "PNG", file);
  if (image.channels != kRgb) {
    throw Error(ErrorKind::bad_data, fmt::format("'{}': found {} channels, expected RGB",
                                                 file.string(), image.channels));
  }
  const std::size_t size = std::size_t{kRgb} * static_cast<std::size_t>(image.width) *
                           static_cast<std::size_t>(image.height);
  return {image.width, image.height, {image.samples.get(), image.samples.get() + size}};
}

FrameState state_of(const std::filesystem::path& file, const std::string& mark,
                    FrameFormat format) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return FrameState::missing;
  const std::vector<std::uint8_t> bytes = bytes_of(file);
  const image::MarkedFile marked =
      format == FrameFormat::png ? image::mark_of_png(bytes) : image::mark_of_exr(bytes);
  if (!marked.is_whole) return FrameState::broken;
  return marked.mark == mark ? FrameState::kept : FrameState::foreign;
}

}  // namespace aerostat::film
