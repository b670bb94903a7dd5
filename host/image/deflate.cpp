#include "image/deflate.hpp"

#include <algorithm>
#include <cstddef>

#include <oneapi/tbb/enumerable_thread_specific.h>
#include <oneapi/tbb/parallel_for.h>
#include <zlib.h>

#include "core/error.hpp"

namespace aerostat::image {
namespace {

constexpr std::size_t kPartBytes = 128 * 1024;
constexpr int kRaw = -15;  // no header, and the largest window

struct Part {
  std::vector<std::uint8_t> bytes;
  std::size_t length = 0;  // bytes of the data that was compressed
  uLong checksum = 0;
};

[[noreturn]] void fail() {
  throw Error(ErrorKind::internal, "zlib failed to compress a picture");
}

/// The state of zlib and a buffer for its output, for one thread.
class Compressor {
 public:
  Compressor() {
    if (deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) != Z_OK)
      fail();
    // The buffer has room for the data and for the mark of a flush.
    room_.resize(deflateBound(&stream_, kPartBytes) + 16);
  }
  ~Compressor() { deflateEnd(&stream_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// Compresses one part. The output ends at a whole byte, so that parts can follow each other.
  /// The last part also ends the stream.
  Part compress(std::span<const std::uint8_t> data, bool last) {
    const auto length = static_cast<uInt>(data.size());
    Part part;
    part.length = data.size();
    part.checksum = adler32(adler32(0, nullptr, 0), data.data(), length);
    if (deflateReset(&stream_) != Z_OK) fail();
    stream_.next_in = const_cast<Bytef*>(data.data());
    stream_.avail_in = length;
    stream_.next_out = room_.data();
    stream_.avail_out = static_cast<uInt>(room_.size());
    const int status = ::deflate(&stream_, last ? Z_FINISH : Z_FULL_FLUSH);
    if (status != (last ? Z_STREAM_END : Z_OK) || stream_.avail_in != 0) fail();
    part.bytes.assign(room_.begin(),
                      room_.begin() + static_cast<std::ptrdiff_t>(stream_.total_out));
    return part;
  }

 private:
  z_stream stream_{};
  std::vector<std::uint8_t> room_;
};

}  // namespace

std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data) {
  const std::size_t count = std::max<std::size_t>(1, (data.size() + kPartBytes - 1) / kPartBytes);
  std::vector<Part> parts(count);
  tbb::enumerable_thread_specific<Compressor> compressors;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const std::size_t first = i * kPartBytes;
    const std::size_t length = std::min(kPartBytes, data.size() - first);
    parts[i] = compressors.local().compress(data.subspan(first, length), i + 1 == count);
  });
  std::vector<std::uint8_t> stream{0x78, 0x01};  // deflate, window of 32 KiB, fastest
  uLong checksum = adler32(0, nullptr, 0);
  for (const Part& part : parts) {
    stream.insert(stream.end(), part.bytes.begin(), part.bytes.end());
    checksum = adler32_combine(checksum, part.checksum, static_cast<z_off_t>(part.length));
  }
  for (const int shift : {24, 16, 8, 0}) {
    stream.push_back(static_cast<std::uint8_t>(checksum >> shift));
  }
  return stream;
}

}  // namespace aerostat::image
