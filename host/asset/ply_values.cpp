#include "asset/ply_values.hpp"

#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "asset/bytes.hpp"
#include "asset/words.hpp"

namespace aerostat::asset {

PlyValues::PlyValues(std::string_view bytes, const PlyHeader& header)
    : bytes_(bytes), header_(header), at_(header.bytes), line_(header.last_line + 1) {}

double PlyValues::next(PlyType type) {
  if (header_.is_text) return next_word();
  if (left() < bytes_of(type)) fail("the end of the file", "more numbers");
  const std::size_t at = at_;
  at_ += bytes_of(type);
  const std::endian order = header_.order;
  switch (type) {
    case PlyType::int8:
      return number_at<std::int8_t>(bytes_, at, order);
    case PlyType::uint8:
      return number_at<std::uint8_t>(bytes_, at, order);
    case PlyType::int16:
      return number_at<std::int16_t>(bytes_, at, order);
    case PlyType::uint16:
      return number_at<std::uint16_t>(bytes_, at, order);
    case PlyType::int32:
      return number_at<std::int32_t>(bytes_, at, order);
    case PlyType::uint32:
      return number_at<std::uint32_t>(bytes_, at, order);
    case PlyType::float32:
      return static_cast<double>(number_at<float>(bytes_, at, order));
    case PlyType::float64:
      break;
  }
  return number_at<double>(bytes_, at, order);
}

double PlyValues::next_word() {
  for (; at_ < bytes_.size(); ++at_) {
    const char c = bytes_[at_];
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') break;
    // A carriage return ends a line unless a line feed follows.
    line_ += c == '\n' || (c == '\r' && bytes_.substr(at_ + 1, 1) != "\n") ? 1 : 0;
  }
  if (at_ == bytes_.size()) fail("the end of the file", "more numbers");
  Words words(bytes_.substr(at_));
  const std::string_view word = words.next();
  at_ += word.size();
  return real_at(word, line_);
}

std::size_t PlyValues::next_length(PlyType count_type, PlyType type) {
  const double length = next(count_type);
  if (!(length >= 0.0) || length != std::floor(length)) {
    fail(fmt::format("a list of {} numbers", length), "a whole number that is not negative");
  }
  if (length * static_cast<double>(least_bytes(type)) > static_cast<double>(left()) + 1.0) {
    fail(fmt::format("a list of {} numbers", length),
         fmt::format("what {} more bytes can hold", left()));
  }
  return static_cast<std::size_t>(length);
}

void PlyValues::require_room(const PlyElement& element) const {
  double bytes = 0.0;
  for (const PlyProperty& property : element.properties) {
    bytes += static_cast<double>(least_bytes(property.count_type.value_or(property.type)));
  }
  const double all = bytes * static_cast<double>(element.count);
  if (all <= static_cast<double>(left()) + 1.0 && (bytes > 0.0 || element.count == 0)) return;
  fail(fmt::format("{} elements {}", element.count, in_quotes(element.name)),
       fmt::format("what {} more bytes can hold", left()));
}

void PlyValues::fail(std::string_view found, std::string_view expected) const {
  refuse(fmt::format("{} {}: found {}, expected {}", header_.is_text ? "line" : "byte",
                     header_.is_text ? line_ : at_, found, expected));
}

}  // namespace aerostat::asset
