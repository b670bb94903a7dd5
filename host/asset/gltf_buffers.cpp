#include "asset/gltf_buffers.hpp"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"
#include "core/error.hpp"

namespace aerostat::asset {
namespace {

constexpr int kNoDigit = 64;

/// Returns the value of a digit of base64 (RFC 4648).
int digit_of(char c) {
  if (c >= 'A' && c <= 'Z') return c - 'A';
  if (c >= 'a' && c <= 'z') return c - 'a' + 26;
  if (c >= '0' && c <= '9') return c - '0' + 52;
  if (c == '+' || c == '-') return 62;
  if (c == '/' || c == '_') return 63;
  return kNoDigit;
}

std::string base64_decoded(std::string_view text, const JsonValue& where) {
  for (int i = 0; i < 2 && text.ends_with('='); ++i) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;  // of bits that are not written yet
  for (std::size_t i = 0; i < text.size(); ++i) {
    const int digit = digit_of(text[i]);
    if (digit == kNoDigit) {
      where.fail(in_quotes(text.substr(i, 8)), "digits of base64");
    }
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes += static_cast<char>(bits >> count & 0xffu);
  }
  return bytes;
}

}  // namespace

std::string bytes_of_data_uri(std::string_view uri, const JsonValue& where) {
  const std::size_t comma = uri.find(',');
  const bool is_base64 =
      comma != std::string_view::npos && uri.substr(0, comma).ends_with(";base64");
  if (!is_base64) where.fail(in_quotes(uri), "a data URI in base64");
  return base64_decoded(uri.substr(comma + 1), where);
}

GltfBuffers::GltfBuffers(const JsonValue& root, std::optional<std::string_view> binary,
                         const Files& files, std::uint64_t most_bytes)
    : files_(files), bytes_left_(most_bytes) {
  const JsonValue buffers = root["buffers"];
  for (std::size_t i = 0; i < buffers.size(); ++i) {
    buffers_.push_back(read_buffer(buffers.at(i), i, binary));
  }
  const JsonValue views = root["bufferViews"];
  for (std::size_t i = 0; i < views.size(); ++i) views_.push_back(read_view(views.at(i)));
}

std::string_view GltfBuffers::keep(std::string bytes, const JsonValue& where) {
  if (bytes.size() > bytes_left_) where.fail("too many bytes", "fewer in all buffers and images");
  bytes_left_ -= bytes.size();
  kept_.push_back(std::move(bytes));
  return kept_.back();
}

std::string_view GltfBuffers::bytes_of_uri(const JsonValue& uri) {
  const std::string text = uri.text();
  if (text.starts_with("data:")) return keep(bytes_of_data_uri(text, uri), uri);
  if (has_scheme(text)) uri.fail("the name of a file beside the model, or a data URI");
  const auto known = by_name_.find(text);
  if (known != by_name_.end()) return known->second;
  std::filesystem::path path;
  try {
    try {
      path = files_.find(percent_decoded(text));
    } catch (const Error&) {
      if (text.find('%') == std::string::npos) throw;
      path = files_.find(text);  // some programs do not encode names
    }
    return by_name_[text] = keep(files_.read(path), uri);
  } catch (const Error& error) {
    refuse(fmt::format("{}: {}", uri.pointer(), error.what()));
  }
}

std::string_view GltfBuffers::read_buffer(const JsonValue& buffer, std::size_t i,
                                          std::optional<std::string_view> binary) {
  const std::uint64_t length = buffer["byteLength"].whole();
  if (length == 0) buffer["byteLength"].fail("at least 1");
  const JsonValue uri = buffer["uri"];
  std::string_view bytes;
  if (uri.exists()) {
    bytes = bytes_of_uri(uri);
  } else if (i == 0 && binary) {
    bytes = *binary;
  } else {
    // A buffer without a URI may stand for one that an extension compresses.
    const std::vector<std::string> extensions = buffer["extensions"].keys();
    uri.fail(extensions.empty() ? "the name of a file or a data URI"
                                : fmt::format("a buffer that is not compressed by {}",
                                              fmt::join(extensions, ", ")));
  }
  if (length > bytes.size()) {
    buffer["byteLength"].fail(fmt::format("at most the {} bytes that are there", bytes.size()));
  }
  return bytes.substr(0, static_cast<std::size_t>(length));
}

GltfView GltfBuffers::read_view(const JsonValue& view) const {
  const std::size_t buffer = view["buffer"].index(buffers_.size(), "buffers");
  const std::string_view bytes = buffers_[buffer];
  const std::uint64_t offset = view["byteOffset"].whole(0), length = view["byteLength"].whole();
  if (length == 0) view["byteLength"].fail("at least 1");
  if (offset > bytes.size() || length > bytes.size() - offset) {
    view.fail(fmt::format("{} bytes from byte {}", length, offset),
              fmt::format("a part of buffer {}, which has {} bytes", buffer, bytes.size()));
  }
  GltfView result;
  result.offset = static_cast<std::size_t>(offset);
  result.bytes = bytes.substr(result.offset, static_cast<std::size_t>(length));
  const JsonValue stride = view["byteStride"];
  if (!stride.exists()) return result;
  const std::uint64_t step = stride.whole();
  if (step < 4 || step > 252 || step % 4 != 0) stride.fail("a multiple of 4 from 4 to 252");
  if (step > length) stride.fail("at most the length of the view");
  result.stride = static_cast<std::size_t>(step);
  return result;
}

}  // namespace aerostat::asset
