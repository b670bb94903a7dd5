#include "asset/ply_header.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "asset/words.hpp"

namespace aerostat::asset {
namespace {

constexpr std::size_t kMostElements = 64;
constexpr std::size_t kMostProperties = 256;  // of one element

struct TypeName {
  std::string_view name;
  PlyType type;
};

constexpr std::array<TypeName, 16> kTypeNames = {{{"char", PlyType::int8},
                                                  {"int8", PlyType::int8},
                                                  {"uchar", PlyType::uint8},
                                                  {"uint8", PlyType::uint8},
                                                  {"short", PlyType::int16},
                                                  {"int16", PlyType::int16},
                                                  {"ushort", PlyType::uint16},
                                                  {"uint16", PlyType::uint16},
                                                  {"int", PlyType::int32},
                                                  {"int32", PlyType::int32},
                                                  {"uint", PlyType::uint32},
                                                  {"uint32", PlyType::uint32},
                                                  {"float", PlyType::float32},
                                                  {"float32", PlyType::float32},
                                                  {"double", PlyType::float64},
                                                  {"float64", PlyType::float64}}};

/// Reads the lines of a header one by one.
class HeaderReader {
 public:
  explicit HeaderReader(std::string_view bytes) : bytes_(bytes), lines_(bytes) {}

  PlyHeader read() {
    std::string_view line;
    while (lines_.next(line)) {
      Words words(line);
      const std::string_view first = words.next();
      if (first == "end_header") return finished(line);
      take(first, words, line);
    }
    refuse("the header of the PLY file has no line \"end_header\"");
  }

 private:
  void take(std::string_view first, Words& words, std::string_view line) {
    if (first == "format") {
      take_format(words);
    } else if (first == "element") {
      take_element(words);
    } else if (first == "property") {
      take_property(words);
    } else if (first == "comment") {
      if (words.next() == "TextureFile") header_.texture_file = words.rest();
    } else if (first != "ply" && first != "obj_info" && !first.empty()) {
      fail(in_quotes(line), "format, element, property, comment, obj_info or end_header");
    }
  }

  PlyHeader finished(std::string_view line) {
    if (!has_format_) fail("the end of the header", "a line \"format\" before it");
    const auto end = static_cast<std::size_t>(line.data() - bytes_.data()) + line.size();
    const std::string_view ending = bytes_.substr(end, 2);
    // If the header ends its lines with carriage returns alone, a line feed behind the last one is
    // the first byte of the body.
    const bool is_pair = ending == "\r\n" && bytes_.substr(0, end).find('\n') != std::string::npos;
    header_.bytes = std::min(bytes_.size(), end + (is_pair ? 2 : 1));
    header_.last_line = lines_.number();
    return std::move(header_);
  }

  void take_format(Words& words) {
    const std::string_view form = words.next(), version = words.next();
    if (version != "1.0") fail(in_quotes(version), "version 1.0 of PLY");
    if (form != "ascii" && form != "binary_little_endian" && form != "binary_big_endian") {
      fail(in_quotes(form), "ascii, binary_little_endian or binary_big_endian");
    }
    header_.is_text = form == "ascii";
    header_.order = form == "binary_big_endian" ? std::endian::big : std::endian::little;
    has_format_ = true;
  }

  void take_element(Words& words) {
    PlyElement element;
    element.name = words.next();
    const std::string_view count = words.next();
    const std::optional<std::int64_t> number = integer_of(count);
    if (!number || *number < 0) fail(in_quotes(count), "the number of elements");
    element.count = static_cast<std::uint64_t>(*number);
    if (header_.elements.size() == kMostElements) {
      fail("one more element", fmt::format("at most {} of them", kMostElements));
    }
    header_.elements.push_back(std::move(element));
  }

  void take_property(Words& words) {
    if (header_.elements.empty()) fail("a property", "an element before it");
    PlyProperty property;
    std::string_view word = words.next();
    if (word == "list") {
      property.count_type = type_of(words.next());
      if (!is_whole(*property.count_type)) fail("a list whose length is a float", "an integer");
      word = words.next();
    }
    property.type = type_of(word);
    property.name = words.next();
    std::vector<PlyProperty>& properties = header_.elements.back().properties;
    if (properties.size() == kMostProperties) {
      fail("one more property", fmt::format("at most {} of an element", kMostProperties));
    }
    properties.push_back(std::move(property));
  }

  PlyType type_of(std::string_view word) const {
    const auto found = std::find_if(kTypeNames.begin(), kTypeNames.end(),
                                    [&](const TypeName& each) { return each.name == word; });
    if (found == kTypeNames.end()) fail(in_quotes(word), "a type such as float, uchar or int");
    return found->type;
  }

  [[noreturn]] void fail(const std::string& found, const std::string& expected) const {
    refuse(fmt::format("line {}: found {}, expected {}", lines_.number(), found, expected));
  }

  std::string_view bytes_;
  Lines lines_;
  PlyHeader header_;
  bool has_format_ = false;
};

}  // namespace

std::size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

bool is_whole(PlyType type) {
  return type != PlyType::float32 && type != PlyType::float64;
}

PlyHeader read_ply_header(std::string_view bytes) {
  return HeaderReader(bytes).read();
}

}  // namespace aerostat::asset
