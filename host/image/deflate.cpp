#include "image/deflate.hpp"

#include <algorithm>

#include <oneapi/tbb/parallel_for.h>
#include <zlib.h>

#include "core/error.hpp"

namespace aerostat::image {
namespace {

constexpr std::size_t kPartBytes = 128 * 1024;
constexpr int kRaw = -15;  // no header, the largest window

struct Part {
  std::vector<std::uint8_t> bytes;
  std::size_t length = 0;  // of what it stands for
  uLong checksum = 0;
  bool failed = false;
};

/// One part, ended on a byte so that parts can follow each other (or as the stream's end).
Part compressed(std::span<const std::uint8_t> data, bool last) {
  Part part;
  part.length = data.size();
  part.checksum = adler32(adler32(0, nullptr, 0), data.data(), static_cast<uInt>(data.size()));
  z_stream stream{};
  if (deflateInit2(&stream, Z_BEST_SPEED, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) != Z_OK) {
    part.failed = true;
    return part;
  }
  // Room for the mark of a flush beside what the data may need.
  part.bytes.resize(deflateBound(&stream, static_cast<uLong>(data.size())) + 16);
  stream.next_in = const_cast<Bytef*>(data.data());
  stream.avail_in = static_cast<uInt>(data.size());
  stream.next_out = part.bytes.data();
  stream.avail_out = static_cast<uInt>(part.bytes.size());
  const int status = ::deflate(&stream, last ? Z_FINISH : Z_FULL_FLUSH);
  part.failed = status != (last ? Z_STREAM_END : Z_OK) || stream.avail_in != 0;
  part.bytes.resize(stream.total_out);
  deflateEnd(&stream);
  return part;
}

}  // namespace

std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data) {
  const std::size_t count = std::max<std::size_t>(1, (data.size() + kPartBytes - 1) / kPartBytes);
  std::vector<Part> parts(count);
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const std::size_t first = i * kPartBytes;
    const std::size_t length = std::min(kPartBytes, data.size() - first);
    parts[i] = compressed(data.subspan(first, length), i + 1 == count);
  });
  std::vector<std::uint8_t> stream{0x78, 0x01};  // deflate, window of 32 KiB, fastest
  uLong checksum = adler32(0, nullptr, 0);
  for (const Part& part : parts) {
    if (part.failed) throw Error(ErrorKind::internal, "zlib failed to compress a picture");
    stream.insert(stream.end(), part.bytes.begin(), part.bytes.end());
    checksum = adler32_combine(checksum, part.checksum, static_cast<z_off_t>(part.length));
  }
  for (const int shift : {24, 16, 8, 0}) {
    stream.push_back(static_cast<std::uint8_t>(checksum >> shift));
  }
  return stream;
}

}  // namespace aerostat::image
