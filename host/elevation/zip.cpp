#include "elevation/zip.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>

#include <fmt/format.h>
#include <zlib.h>

#include "elevation/reading.hpp"

namespace aerostat::elevation {
namespace {

using Bytes = std::span<const std::uint8_t>;

// The most members of a zip file that are looked at.
constexpr std::size_t kMostMembers = 4096;
// Deflate makes at most this many bytes of one.
constexpr std::uint64_t kMostGrowth = 1032;

std::uint32_t number(Bytes bytes, std::size_t at, int count) {
  std::uint32_t value = 0;
  for (int i = count - 1; i >= 0; --i) value = value << 8 | bytes[at + static_cast<std::size_t>(i)];
  return value;
}

bool has_mark(Bytes bytes, std::size_t at, std::uint32_t mark, std::size_t length) {
  return at <= bytes.size() && bytes.size() - at >= length && number(bytes, at, 4) == mark;
}

/// An entry of the central directory.
struct Entry {
  std::string name;
  std::uint32_t flags = 0, method = 0, checksum = 0, packed = 0, unpacked = 0, header = 0;
};

/// Returns where the record of the end begins, which a comment may follow.
std::size_t end_record(Bytes bytes, const std::filesystem::path& path) {
  constexpr std::size_t kLength = 22, kComment = 65535;
  if (bytes.size() >= kLength) {
    const std::size_t last = bytes.size() - kLength;
    const std::size_t first = last > kComment ? last - kComment : 0;
    for (std::size_t at = last + 1; at-- > first;) {
      if (number(bytes, at, 4) == 0x06054b50u) return at;
    }
  }
  refuse(path, "the zip file is cut short: its directory is missing");
}

std::vector<Entry> entries_of(Bytes bytes, const std::filesystem::path& path) {
  const std::size_t end = end_record(bytes, path);
  const std::size_t count = number(bytes, end + 10, 2);
  std::size_t at = number(bytes, end + 16, 4);
  if (count == 0xffffu || at == 0xffffffffu) {
    refuse(path, "it is a zip file of the large kind (zip64), which is not read; unpack it");
  }
  if (count > kMostMembers) {
    refuse(path, fmt::format("the zip file has {} members, and at most {} are looked at", count,
                             kMostMembers));
  }
  std::vector<Entry> entries;
  for (std::size_t i = 0; i < count; ++i) {
    constexpr std::size_t kLength = 46;
    if (!has_mark(bytes, at, 0x02014b50u, kLength)) {
      refuse(path, fmt::format("the directory of the zip file is damaged at member {}", i + 1));
    }
    const std::size_t name = number(bytes, at + 28, 2);
    const std::size_t rest = number(bytes, at + 30, 2) + number(bytes, at + 32, 2);
    if (bytes.size() - at - kLength < name) {
      refuse(path, fmt::format("the directory of the zip file is damaged at member {}", i + 1));
    }
    const Bytes letters = bytes.subspan(at + kLength, name);
    entries.push_back({std::string(letters.begin(), letters.end()), number(bytes, at + 8, 2),
                       number(bytes, at + 10, 2), number(bytes, at + 16, 4),
                       number(bytes, at + 20, 4), number(bytes, at + 24, 4),
                       number(bytes, at + 42, 4)});
    at += kLength + name + rest;
  }
  return entries;
}

Entry entry_with(const std::vector<Entry>& entries, std::string_view ending,
                 const std::filesystem::path& path) {
  std::optional<Entry> found;
  for (const Entry& entry : entries) {
    // macOS adds a file with its own attributes for each member.
    if (entry.name.starts_with("__MACOSX/") || !lower_case(entry.name).ends_with(ending)) continue;
    if (found) {
      refuse(path, fmt::format("the zip file has more than one {} file; unpack it, and name the "
                               "folder or the list of files",
                               ending));
    }
    found = entry;
  }
  if (!found) {
    refuse(
        path,
        fmt::format(
            "the zip file has {} members, and none of them is a {} file; unpack it to read others",
            entries.size(), ending));
  }
  return *found;
}

/// Inflates at most `most` bytes and returns them, or nothing if the stream is damaged, cut short
/// or longer.
std::optional<std::vector<std::uint8_t>> inflate_all(Bytes packed, int window_bits,
                                                     std::uint64_t most) {
  z_stream stream{};
  if (inflateInit2(&stream, window_bits) != Z_OK) return std::nullopt;
  std::vector<std::uint8_t> bytes;
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  int code = Z_OK;
  std::size_t taken = 0, made = 0;
  while (code == Z_OK && made <= most) {
    if (stream.avail_in == 0) {
      const std::size_t piece = std::min<std::size_t>(packed.size() - taken, kPiece);
      stream.next_in = const_cast<Bytef*>(packed.data() + taken);
      stream.avail_in = static_cast<uInt>(piece);
      taken += piece;
    }
    bytes.resize(made + kPiece);
    stream.next_out = bytes.data() + made;
    stream.avail_out = static_cast<uInt>(kPiece);
    code = inflate(&stream, Z_NO_FLUSH);
    made += kPiece - stream.avail_out;
  }
  inflateEnd(&stream);
  if (code != Z_STREAM_END || made > most) return std::nullopt;
  bytes.resize(made);
  return bytes;
}

Bytes packed_bytes(Bytes bytes, const Entry& entry, const std::filesystem::path& path) {
  constexpr std::size_t kLength = 30;
  const std::size_t at = entry.header;
  if (has_mark(bytes, at, 0x04034b50u, kLength)) {
    const std::size_t first = at + kLength + number(bytes, at + 26, 2) + number(bytes, at + 28, 2);
    if (first <= bytes.size() && bytes.size() - first >= entry.packed) {
      return bytes.subspan(first, entry.packed);
    }
  }
  refuse(path, fmt::format("the zip file is damaged: {} does not lie in it", entry.name));
}

}  // namespace

ZipMember unpack_zip(Bytes bytes, const std::filesystem::path& path, std::string_view ending,
                     std::uint64_t most) {
  const Entry entry = entry_with(entries_of(bytes, path), ending, path);
  if ((entry.flags & 1u) != 0) refuse(path, fmt::format("{} in it is encrypted", entry.name));
  if (entry.packed == 0xffffffffu || entry.unpacked == 0xffffffffu) {
    refuse(path, "it is a zip file of the large kind (zip64), which is not read; unpack it");
  }
  if (entry.unpacked > most) {
    refuse(path, fmt::format("{} in it has {} bytes, and at most {} are expected", entry.name,
                             entry.unpacked, most));
  }
  if (entry.method != 0 && entry.method != 8) {
    refuse(path, fmt::format("{} in it is packed by method {}; deflate (8) is expected", entry.name,
                             entry.method));
  }
  const Bytes packed = packed_bytes(bytes, entry, path);
  ZipMember member{entry.name.substr(entry.name.find_last_of("/\\") + 1), {}};
  if (entry.method == 0) {
    member.bytes.assign(packed.begin(), packed.end());
  } else if (entry.unpacked <= packed.size() * kMostGrowth + kMostGrowth) {
    member.bytes =
        inflate_all(packed, -MAX_WBITS, entry.unpacked).value_or(std::vector<std::uint8_t>());
  }
  if (member.bytes.size() != entry.unpacked ||
      crc32(0, member.bytes.data(), static_cast<uInt>(member.bytes.size())) != entry.checksum) {
    refuse(path, fmt::format("{} in it is damaged: it unpacks to other bytes than the zip file's "
                             "directory says",
                             entry.name));
  }
  return member;
}

std::vector<std::uint8_t> unpack_gzip(Bytes bytes, const std::filesystem::path& path,
                                      std::uint64_t most) {
  auto unpacked = inflate_all(bytes, MAX_WBITS + 16, most);
  if (!unpacked) {
    refuse(path, fmt::format("the gzip file is damaged, or it has more than {} bytes", most));
  }
  return std::move(*unpacked);
}

}  // namespace aerostat::elevation
