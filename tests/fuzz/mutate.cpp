#include "mutate.hpp"

#include <algorithm>
#include <cctype>
#include <utility>

namespace aerostat::test {

namespace {

// Values that readers often handle wrongly.
const std::vector<std::string> kValues = {"0",
                                          "-0.0",
                                          "-1",
                                          "1e308",
                                          "-1e308",
                                          "1e400",
                                          "1e-400",
                                          "4294967295",
                                          "4294967296",
                                          "18446744073709551616",
                                          "-9223372036854775809",
                                          "0.1e",
                                          "NaN",
                                          "Infinity",
                                          "0x10",
                                          "01",
                                          "+1",
                                          "null",
                                          "true",
                                          "false",
                                          "\"\"",
                                          "\"snow\"",
                                          "\"\\u0000\"",
                                          "\"\\ud800\"",
                                          "\"\xff\"",
                                          "[]",
                                          "{}",
                                          "[[[[[[]]]]]]",
                                          "[1,2,3]",
                                          "[0,0,0]",
                                          "[1e400,0,0]",
                                          "{\"a\":{\"a\":{\"a\":1}}}",
                                          "//",
                                          "/*",
                                          "*/",
                                          "\"2024-02-30\"",
                                          "\"24:60\"",
                                          "\"-0001-01-01\"",
                                          "[{\"position\":[0,0,0]}]"};

const std::vector<std::string> kPointers = {"/biome",
                                            "/biome/kind",
                                            "/terrain/cells",
                                            "/terrain",
                                            "/lights/0/position/1",
                                            "/lights/-",
                                            "/lights/18446744073709551616",
                                            "/balloon/colors/0/0",
                                            "/camera/up",
                                            "/sun/direction",
                                            "/sun/date",
                                            "/sun/azimuth_deg",
                                            "/image/width",
                                            "/quality",
                                            "",
                                            "/",
                                            "//",
                                            "/~",
                                            "/~2",
                                            "/~0~1",
                                            "/\xff",
                                            "/version",
                                            "/materials/flame/emission/2",
                                            "/camera/view",
                                            "no",
                                            "/image/width/x"};

bool is_word(char character) {
  return std::isalnum(static_cast<unsigned char>(character)) != 0 || character == '.' ||
         character == '-' || character == '_';
}

}  // namespace

Mutator::Mutator(std::vector<std::string> corpus, std::uint32_t seed)
    : corpus_(std::move(corpus)), random_(seed) {}

std::size_t Mutator::below(std::size_t count) {
  // A distribution of the standard library is not used, because libraries differ in their results.
  return random_() % std::max<std::size_t>(count, 1);
}

void Mutator::change_bytes(std::string& text) {
  static const std::string kBytes("{}[]\",:/*\\-+.eE0 9\n\0\x7f\xc3\xff", 23);
  const std::size_t at = below(text.size() + 1);
  const char byte = kBytes[below(kBytes.size())];
  switch (below(4)) {
    case 0:
      text.insert(at, 1, byte);
      break;
    case 1:
      if (at < text.size()) text[at] = byte;
      break;
    case 2:
      if (at < text.size()) text[at] = static_cast<char>(text[at] ^ 1 << below(8));
      break;
    default:
      text.erase(at, 1 + below(4));
  }
}

void Mutator::change_piece(std::string& text) {
  const std::size_t at = below(text.size() + 1), length = below(200);
  switch (below(5)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
      text.insert(below(text.size() + 1), text.substr(at, length));
      break;
    case 2: {
      const std::string& other = any_text();
      text.insert(at, other.substr(below(other.size() + 1), length));
      break;
    }
    case 3:
      text.resize(at);
      break;
    default:
      text.insert(at, std::string(1 + below(3000), below(2) == 0 ? '[' : ' '));
  }
}

/// Replaces a number, a word or a string by a value or by another token of the text.
void Mutator::change_token(std::string& text) {
  const auto token_at = [&text, this] {
    std::size_t start = below(text.size() + 1);
    while (start < text.size() && !is_word(text[start])) ++start;
    std::size_t end = start;
    while (start > 0 && is_word(text[start - 1])) --start;
    while (end < text.size() && is_word(text[end])) ++end;
    const bool quoted =
        start > 0 && end < text.size() && text[start - 1] == '"' && text[end] == '"';
    return quoted ? std::pair{start - 1, end + 1} : std::pair{start, end};
  };
  const auto [from, to] = token_at();
  const std::string source = text.substr(from, to - from);
  if (below(3) != 0) {
    text.replace(from, to - from, kValues[below(kValues.size())]);
    return;
  }
  const auto [other_from, other_to] = token_at();
  text.replace(other_from, other_to - other_from, source);
}

std::string Mutator::next() {
  std::string text = any_text();
  for (std::size_t changes = 1 + below(8); changes > 0; --changes) {
    switch (below(6)) {
      case 0:
        change_bytes(text);
        break;
      case 1:
        change_piece(text);
        break;
      default:
        change_token(text);
    }
  }
  return text;
}

std::string Mutator::next_override() {
  std::string text = kPointers[below(kPointers.size())] + "=" + kValues[below(kValues.size())];
  if (below(4) == 0) change_bytes(text);
  return text;
}

}  // namespace aerostat::test
