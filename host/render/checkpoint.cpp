#include "render/checkpoint.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <string_view>
#include <system_error>
#include <type_traits>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/checksum.hpp"
#include "core/error.hpp"
#include "core/file.hpp"

namespace aerostat::render {
namespace {

static_assert(std::endian::native == std::endian::little, "checkpoints are little-endian");

constexpr std::string_view kMagic = "aerostat checkpoint 1\n";
constexpr std::string_view kAnyMagic = "aerostat checkpoint ";
/// The line of the format, the checksum of the head and its size.
constexpr std::size_t kPreludeBytes = kMagic.size() + sizeof(std::uint64_t) + sizeof(std::uint32_t);

std::string_view text_of(std::span<const std::uint8_t> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

template <typename T>
std::span<const std::uint8_t> bytes_of(const Array<T>& values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size() * sizeof(T)};
}

/// Returns a checksum of many bytes. It goes through them word by word in eight rows, which is
/// several times faster than `checksum`.
std::uint64_t checksum_of(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t kRows = 8;
  std::array<std::uint64_t, kRows> rows{};
  rows.fill(0xcbf29ce484222325u);
  std::size_t at = 0;
  for (; at + sizeof(rows) <= bytes.size(); at += sizeof(rows)) {
    std::array<std::uint64_t, kRows> words;
    std::memcpy(words.data(), bytes.data() + at, sizeof(words));
    for (std::size_t i = 0; i < kRows; ++i) {
      rows[i] = std::rotl((rows[i] ^ words[i]) * 0x9e3779b97f4a7c15u, 29);
    }
  }
  const std::string_view sums(reinterpret_cast<const char*>(rows.data()), sizeof(rows));
  return checksum(std::string(sums) + std::string(text_of(bytes.subspan(at))));
}

/// Puts values one behind the other.
class Writer {
 public:
  template <typename T>
  void put(T value) {
    static_assert(std::is_arithmetic_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }
  void put_text(std::string_view text) {
    put(static_cast<std::uint32_t>(text.size()));
    bytes_.append(text);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Takes values one behind the other. Throws Error{bad_data} where the bytes end too soon.
class Reader {
 public:
  Reader(std::string_view bytes, const std::string& name) : rest_(bytes), name_(name) {}

  template <typename T>
  T take() {
    static_assert(std::is_arithmetic_v<T>);
    T value{};
    std::memcpy(&value, part(sizeof(T)).data(), sizeof(T));
    return value;
  }
  std::string take_text() { return std::string(part(take<std::uint32_t>())); }
  bool is_at_end() const { return rest_.empty(); }

 private:
  std::string_view part(std::size_t bytes) {
    if (bytes > rest_.size()) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("checkpoint '{}': its head ends too soon; remove the file", name_));
    }
    const std::string_view first = rest_.substr(0, bytes);
    rest_.remove_prefix(bytes);
    return first;
  }

  std::string_view rest_;
  const std::string& name_;
};

[[noreturn]] void refuse(const std::string& name, const std::string& why) {
  throw Error(ErrorKind::bad_data, fmt::format("checkpoint '{}': {}", name, why));
}

[[noreturn]] void refuse_damaged(const std::string& name, const std::string& what) {
  refuse(name, fmt::format("the file is damaged: {}; remove it to begin anew", what));
}

std::string head_of(const Traits& traits, const FilmSums& sums) {
  Writer head;
  head.put(static_cast<std::uint32_t>(traits.size()));
  for (const Trait& trait : traits) {
    head.put_text(trait.name);
    head.put_text(trait.value);
  }
  for (const int side : {sums.window.x0, sums.window.y0, sums.window.x1, sums.window.y1}) {
    head.put(side);
  }
  head.put(sums.samples_done);
  head.put(sums.metered_ev);
  head.put(static_cast<std::uint32_t>(sums.waiting.size()));
  for (const RowRange& rows : sums.waiting) {
    head.put(rows.y0);
    head.put(rows.y1);
  }
  head.put(std::uint8_t{sums.guides.empty() ? std::uint8_t{0} : std::uint8_t{1}});
  head.put(checksum_of(bytes_of(sums.pixels)));
  head.put(checksum_of(bytes_of(sums.guides)));
  return head.bytes();
}

/// What the head of a checkpoint says. The sums have no pixels yet.
struct Head {
  Traits traits;
  FilmSums sums;
  bool has_guides = false;
  std::uint64_t pixels_checksum = 0, guides_checksum = 0;
};

/// What stands in front of the head.
struct Prelude {
  std::uint64_t head_checksum = 0;
  std::uint32_t head_bytes = 0;
};

Prelude parse_prelude(std::string_view text, const std::string& name) {
  if (!text.starts_with(kAnyMagic)) refuse(name, "this is no checkpoint");
  if (!text.starts_with(kMagic)) {
    refuse(name, "its format is that of another version of aerostat; remove it to begin anew");
  }
  if (text.size() < kPreludeBytes) refuse_damaged(name, "it ends too soon");
  Reader from(text.substr(kMagic.size(), kPreludeBytes - kMagic.size()), name);
  Prelude prelude;
  prelude.head_checksum = from.take<std::uint64_t>();
  prelude.head_bytes = from.take<std::uint32_t>();
  if (prelude.head_bytes > kMostHeadBytes) refuse_damaged(name, "its head is too long");
  return prelude;
}

/// Returns the head's bytes, of which nothing else is known than that they are undamaged. `bytes`
/// are those of the file up to the end of the head at least.
std::string_view whole_head(std::span<const std::uint8_t> bytes, const std::string& name) {
  const std::string_view text = text_of(bytes);
  const Prelude prelude = parse_prelude(text, name);
  const std::string_view head = text.substr(kPreludeBytes, prelude.head_bytes);
  if (head.size() < prelude.head_bytes) refuse_damaged(name, "it ends too soon");
  if (checksum(head) != prelude.head_checksum) {
    refuse_damaged(name, "the checksum of its head is wrong");
  }
  return head;
}

Head parse_head(std::string_view bytes, const std::string& name) {
  Reader from(bytes, name);
  Head head;
  const auto traits = from.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < traits; ++i) {
    std::string trait = from.take_text();
    head.traits.push_back({std::move(trait), from.take_text()});
  }
  for (int* side :
       {&head.sums.window.x0, &head.sums.window.y0, &head.sums.window.x1, &head.sums.window.y1}) {
    *side = from.take<int>();
  }
  head.sums.samples_done = from.take<int>();
  head.sums.metered_ev = from.take<double>();
  const auto runs = from.take<std::uint32_t>();
  for (std::uint32_t i = 0; i < runs; ++i) {
    const int y0 = from.take<int>();
    head.sums.waiting.push_back({y0, from.take<int>()});
  }
  head.has_guides = from.take<std::uint8_t>() != 0;
  head.pixels_checksum = from.take<std::uint64_t>();
  head.guides_checksum = from.take<std::uint64_t>();
  if (!from.is_at_end()) refuse_damaged(name, "its head is too long");
  return head;
}

void require_same(const Traits& found, const Traits& expected, const std::string& name) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    const Trait one = i < found.size() ? found[i] : Trait{expected[i].name, "nothing"};
    if (one == expected[i]) continue;
    refuse(name, fmt::format("it is of another {}: found {}, expected {}; give another file, or "
                             "remove this one to begin anew",
                             expected[i].name, one.value, expected[i].value));
  }
  if (found.size() != expected.size()) refuse_damaged(name, "it has more traits than a render");
}

/// Throws an Error unless the numbers are such as a render makes. The checksums tell damage, but
/// not that a file was made on purpose.
void require_sound(const FilmSums& sums, int samples, const std::string& name) {
  if (!std::isfinite(sums.metered_ev)) refuse_damaged(name, "its exposure is no number");
  const auto most = static_cast<std::uint32_t>(samples);
  for (const AeroFilmPixel& pixel : sums.pixels) {
    const bool covers = pixel.coverage >= 0.0f && pixel.coverage <= static_cast<float>(samples);
    if (pixel.samples > most || !covers || pixel.converged > 1) {
      refuse_damaged(name, "a pixel has impossible sums");
    }
  }
}

std::uint64_t bytes_of_sums(const Crop& window, bool with_guides) {
  const std::uint64_t each = sizeof(AeroFilmPixel) + (with_guides ? sizeof(AeroFilmGuide) : 0);
  return window.pixels() * each;
}

template <typename T>
void fill(Array<T>& values, std::size_t count, std::span<const std::uint8_t>& bytes,
          std::uint64_t sum, const std::string& name) {
  const auto part = bytes.first(count * sizeof(T));
  if (checksum_of(part) != sum) refuse_damaged(name, "the checksum of its pixels is wrong");
  values.resize(count);
  if (count > 0) std::memcpy(values.data(), part.data(), part.size());
  bytes = bytes.subspan(part.size());
}

class File {
 public:
  explicit File(int descriptor) : descriptor_(descriptor) {}
  ~File() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  int descriptor() const { return descriptor_; }

  /// Returns up to `most` bytes from the present place on.
  std::vector<std::uint8_t> read(std::size_t most, const std::string& name) const {
    std::vector<std::uint8_t> bytes(most);
    std::size_t done = 0;
    while (done < most) {
      const ssize_t count = ::read(descriptor_, bytes.data() + done, most - done);
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(name);
      if (count == 0) break;
      done += static_cast<std::size_t>(count);
    }
    bytes.resize(done);
    return bytes;
  }

  [[noreturn]] static void fail(const std::string& name) {
    throw Error(ErrorKind::io, fmt::format("cannot read the checkpoint '{}': {}", name,
                                           std::generic_category().message(errno)));
  }

 private:
  int descriptor_;
};

/// Checks all but the sums. Returns the size that the file must have.
std::uint64_t check_head(const Head& head, std::size_t head_bytes, const std::string& name,
                         const Traits& traits, const Crop& window, int samples, bool with_guides) {
  require_same(head.traits, traits, name);
  if (head.has_guides != with_guides) refuse_damaged(name, "it has other layers");
  try {
    require_fitting(head.sums, window, samples);
  } catch (const Error& error) {
    refuse_damaged(name, error.what());
  }
  return kPreludeBytes + head_bytes + bytes_of_sums(window, with_guides);
}

}  // namespace

void write_checkpoint(const std::filesystem::path& path, const Traits& traits,
                      const FilmSums& sums) {
  const std::string head = head_of(traits, sums);
  if (head.size() > kMostHeadBytes) {
    throw Error(ErrorKind::usage,
                fmt::format("cannot write '{}': the head of the checkpoint takes {} bytes, at most "
                            "{} are possible",
                            path.string(), head.size(), kMostHeadBytes));
  }
  Writer prelude;
  prelude.put(checksum(head));
  prelude.put(static_cast<std::uint32_t>(head.size()));
  const std::string front = std::string(kMagic) + prelude.bytes() + head;
  const std::array parts{
      std::span(reinterpret_cast<const std::uint8_t*>(front.data()), front.size()),
      bytes_of(sums.pixels), bytes_of(sums.guides)};
  write_file_of(path, parts);
}

FilmSums parse_checkpoint(std::span<const std::uint8_t> bytes, const std::string& name,
                          const Traits& traits, const Crop& window, int samples, bool with_guides) {
  const std::string_view head_text = whole_head(bytes, name);
  Head head = parse_head(head_text, name);
  const std::uint64_t size =
      check_head(head, head_text.size(), name, traits, window, samples, with_guides);
  if (bytes.size() != size) {
    refuse_damaged(name, fmt::format("it has {} bytes in place of {}", bytes.size(), size));
  }
  auto rest = bytes.subspan(kPreludeBytes + head_text.size());
  const std::size_t pixels = window.pixels();
  fill(head.sums.pixels, pixels, rest, head.pixels_checksum, name);
  fill(head.sums.guides, with_guides ? pixels : 0, rest, head.guides_checksum, name);
  require_sound(head.sums, samples, name);
  return std::move(head.sums);
}

std::optional<FilmSums> read_checkpoint(const std::filesystem::path& path, const Traits& traits,
                                        const Crop& window, int samples, bool with_guides) {
  const std::string name = path.string();
  // O_NONBLOCK is needed because opening a pipe in the place of the file would wait for a writer.
  const File file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.descriptor() < 0 && errno == ENOENT) return std::nullopt;
  struct stat status = {};
  if (file.descriptor() < 0 || ::fstat(file.descriptor(), &status) != 0) File::fail(name);
  if (!S_ISREG(status.st_mode)) refuse(name, "this is no regular file");
  std::vector<std::uint8_t> bytes = file.read(kPreludeBytes, name);
  const auto more = file.read(parse_prelude(text_of(bytes), name).head_bytes, name);
  bytes.insert(bytes.end(), more.begin(), more.end());
  const std::string_view head_text = whole_head(bytes, name);
  const Head head = parse_head(head_text, name);
  const std::uint64_t size =
      check_head(head, head_text.size(), name, traits, window, samples, with_guides);
  if (static_cast<std::uint64_t>(status.st_size) != size) {
    refuse_damaged(name, fmt::format("it has {} bytes in place of {}", status.st_size, size));
  }
  const auto rest = file.read(static_cast<std::size_t>(size) - bytes.size(), name);
  bytes.insert(bytes.end(), rest.begin(), rest.end());
  return parse_checkpoint(bytes, name, traits, window, samples, with_guides);
}

}  // namespace aerostat::render
