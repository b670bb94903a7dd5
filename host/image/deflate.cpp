#include "image/deflate.hpp"

#include <algorithm>

#include <oneapi/tbb/enumerable_thread_specific.h>
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
};

[[noreturn]] void fail() {
  throw Error(ErrorKind::internal, "zlib failed to compress a picture");
}

/// zlib's state and room for a part, for one thread.
class Compressor {
 public:
  Compressor() : data_(kPartBytes) {
    if (deflateInit2(&stream_, Z_BEST_SPEED, Z_DEFLATED, kRaw, 9, Z_DEFAULT_STRATEGY) != Z_OK)
      fail();
    // Room for the mark of a flush beside what the data may need.
    room_.resize(deflateBound(&stream_, kPartBytes) + 16);
  }
  ~Compressor() { deflateEnd(&stream_); }
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;

  /// One part, ended on a byte so that parts can follow each other (or as the stream's end).
  Part compress(std::size_t first, std::size_t length, bool last, const FillPart& fill) {
    fill(first, std::span(data_).first(length));
    Part part;
    part.length = length;
    part.checksum = adler32(adler32(0, nullptr, 0), data_.data(), static_cast<uInt>(length));
    if (deflateReset(&stream_) != Z_OK) fail();
    stream_.next_in = data_.data();
    stream_.avail_in = static_cast<uInt>(length);
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
  std::vector<std::uint8_t> data_, room_;
};

}  // namespace

void append_deflated(std::vector<std::uint8_t>& to, std::size_t length, const FillPart& fill) {
  const std::size_t count = std::max<std::size_t>(1, (length + kPartBytes - 1) / kPartBytes);
  std::vector<Part> parts(count);
  tbb::enumerable_thread_specific<Compressor> compressors;
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    const std::size_t first = i * kPartBytes;
    parts[i] = compressors.local().compress(first, std::min(kPartBytes, length - first),
                                            i + 1 == count, fill);
  });
  to.insert(to.end(), {0x78, 0x01});  // deflate, window of 32 KiB, fastest
  uLong checksum = adler32(0, nullptr, 0);
  for (const Part& part : parts) {
    to.insert(to.end(), part.bytes.begin(), part.bytes.end());
    checksum = adler32_combine(checksum, part.checksum, static_cast<z_off_t>(part.length));
  }
  for (const int shift : {24, 16, 8, 0}) to.push_back(static_cast<std::uint8_t>(checksum >> shift));
}

std::vector<std::uint8_t> deflate(std::span<const std::uint8_t> data) {
  std::vector<std::uint8_t> stream;
  append_deflated(stream, data.size(), [data](std::size_t first, std::span<std::uint8_t> part) {
    std::copy_n(data.begin() + static_cast<std::ptrdiff_t>(first), part.size(), part.begin());
  });
  return stream;
}

}  // namespace aerostat::image
