#include "packed.hpp"

#include <cstddef>

#include <zlib.h>

namespace aerostat::elevation {
namespace {

std::string deflated(const std::string& bytes, int window_bits) {
  z_stream stream{};
  deflateInit2(&stream, 1, Z_DEFLATED, window_bits, 8, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, bytes.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string number(std::size_t value, int bytes) {
  std::string text;
  for (int i = 0; i < bytes; ++i) text += static_cast<char>(value >> (8 * i) & 255u);
  return text;
}

}  // namespace

std::string gzip(const std::string& bytes) {
  return deflated(bytes, MAX_WBITS + 16);
}

std::string zip(const std::vector<std::pair<std::string, std::string>>& members, int method,
                int flags) {
  std::string file, directory;
  for (const auto& [name, bytes] : members) {
    const std::string packed = method == 0 ? bytes : deflated(bytes, -MAX_WBITS);
    const std::size_t checksum =
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size()));
    const std::string common = number(20, 2) + number(static_cast<std::size_t>(flags), 2) +
                               number(static_cast<std::size_t>(method), 2) + number(0, 4) +
                               number(checksum, 4) + number(packed.size(), 4) +
                               number(bytes.size(), 4) + number(name.size(), 2) + number(0, 2);
    directory += "PK\x01\x02" + number(20, 2) + common + std::string(10, '\0') +
                 number(file.size(), 4) + name;
    file += "PK\x03\x04" + common + name + packed;
  }
  return file + directory + "PK\x05\x06" + number(0, 4) + number(members.size(), 2) +
         number(members.size(), 2) + number(directory.size(), 4) + number(file.size(), 4) +
         number(0, 2);
}

}  // namespace aerostat::elevation
