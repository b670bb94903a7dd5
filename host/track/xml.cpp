#include "track/xml.hpp"

#include <cstddef>
#include <exception>
#include <memory>

#include <expat.h>
#include <fmt/format.h>

#include "core/error.hpp"
#include "track/text.hpp"

namespace aerostat::track {

namespace {

constexpr int kDeepest = 100;
constexpr const char* kLatin1 = "ISO-8859-1";

struct Freer {
  void operator()(XML_Parser parser) const { XML_ParserFree(parser); }
};
using Parser = std::unique_ptr<XML_ParserStruct, Freer>;

/// Carries the calls of expat, which is written in C, to a handler. No exception may pass through
/// expat, so the first one is kept and thrown afterwards.
struct Reading {
  XmlHandler& handler;
  XML_Parser parser = nullptr;
  int depth = 0;
  std::string text;
  std::string foreign_encoding;
  std::exception_ptr failure;

  template <class Action>
  void guarded(Action action) {
    if (failure) return;
    try {
      action();
    } catch (...) {
      failure = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }
};

Reading& reading_of(void* user) {
  return *static_cast<Reading*>(user);
}

void on_begin(void* user, const char* name, const char** attributes) {
  Reading& reading = reading_of(user);
  reading.guarded([&] {
    if (++reading.depth > kDeepest) {
      throw Error(ErrorKind::bad_data,
                  fmt::format("the XML is nested deeper than {} elements", kDeepest));
    }
    reading.text.clear();
    reading.handler.begin(local_name(name), XmlAttributes(attributes));
  });
}

void on_end(void* user, const char* name) {
  Reading& reading = reading_of(user);
  reading.guarded([&] {
    --reading.depth;
    reading.handler.end(local_name(name), reading.text);
    reading.text.clear();
  });
}

void on_text(void* user, const char* text, int length) {
  Reading& reading = reading_of(user);
  reading.guarded([&] { reading.text.append(text, static_cast<std::size_t>(length)); });
}

/// Refuses a file that declares entities. No format of tracks needs them, and they can be used to
/// fill the memory or to read other files.
void on_entity(void* user, const char* name, int, const char*, int, const char*, const char*,
               const char*, const char*) {
  reading_of(user).guarded([&] {
    throw Error(ErrorKind::bad_data,
                fmt::format("the XML declares the entity '{}'; files of tracks declare none",
                            clean_text(name)));
  });
}

/// Takes every encoding that expat does not know for Latin-1. Digits and the names of elements are
/// the same in all encodings of one byte.
int on_encoding(void* user, const char* name, XML_Encoding* encoding) {
  reading_of(user).foreign_encoding = clean_text(name);
  for (int i = 0; i < 256; ++i) encoding->map[i] = i;
  encoding->data = nullptr;
  encoding->convert = nullptr;
  encoding->release = nullptr;
  return XML_STATUS_OK;
}

Parser parser_for(Reading& reading, const char* encoding) {
  Parser parser(XML_ParserCreate(encoding));
  if (!parser) throw Error(ErrorKind::exhausted, "no memory is left to read XML");
  reading.parser = parser.get();
  XML_SetUserData(parser.get(), &reading);
  XML_SetElementHandler(parser.get(), on_begin, on_end);
  XML_SetCharacterDataHandler(parser.get(), on_text);
  XML_SetEntityDeclHandler(parser.get(), on_entity);
  XML_SetUnknownEncodingHandler(parser.get(), on_encoding, &reading);
  return parser;
}

/// Returns how the encoding must be set by hand. A file that promises UTF-8 and breaks the promise
/// is read as Latin-1.
const char* forced_encoding(std::string_view bytes) {
  const std::string_view head = bytes.substr(0, 200);
  const bool is_utf16 = head.size() > 1 && head.find('\0') != std::string_view::npos;
  const bool has_mark = head.substr(0, 2) == "\xff\xfe" || head.substr(0, 2) == "\xfe\xff";
  const std::size_t declared = head.find("encoding=");
  const std::string_view name =
      declared + 10 < head.size() ? head.substr(declared + 10, 3) : std::string_view();
  const bool is_declared_utf8 =
      declared == std::string_view::npos || name == "UTF" || name == "utf";
  if (is_utf16 || has_mark || !is_declared_utf8 || is_utf8(bytes)) return nullptr;
  return kLatin1;
}

/// Returns the characters that end a comment, a declaration or the like.
std::string_view closing_of(std::string_view text) {
  if (text.substr(0, 4) == "<!--") return "-->";
  return text.find('[') < text.find('>') ? "]>" : ">";
}

/// Returns the line at which a parser stands. Expat of Debian 13 calls the function deprecated, and
/// that of Debian 12 does not have the one that takes its place.
XML_Size line_of(const Parser& parser) {
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
  return XML_GetCurrentLineNumber(parser.get());
#pragma GCC diagnostic pop
}

}  // namespace

std::optional<std::string_view> XmlAttributes::value(std::string_view name) const {
  for (const char* const* pair = pairs_; pair != nullptr && pair[0] != nullptr; pair += 2) {
    if (local_name(pair[0]) == name) return pair[1];
  }
  return std::nullopt;
}

std::string_view local_name(std::string_view name) {
  return name.substr(name.rfind(':') + 1);
}

std::vector<std::string> read_xml(std::string_view bytes, XmlHandler& handler) {
  std::vector<std::string> notes;
  Reading reading{handler, nullptr, 0, {}, {}, nullptr};
  // Loggers put white space before the declaration, which XML forbids.
  if (!bytes.empty() && bytes[0] != '\0') bytes = trimmed(bytes);
  const char* forced = forced_encoding(bytes);
  const Parser parser = parser_for(reading, forced);
  if (forced != nullptr) {
    notes.emplace_back("The file is not UTF-8 as it says and was read as Latin-1.");
  }
  const XML_Status status =
      XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), XML_TRUE);
  if (reading.failure) std::rethrow_exception(reading.failure);
  if (!reading.foreign_encoding.empty()) {
    notes.push_back(fmt::format("The encoding '{}' was read as Latin-1, so names may look wrong.",
                                reading.foreign_encoding));
  }
  if (status == XML_STATUS_OK) return notes;
  const std::string fault = fmt::format("the XML is damaged at line {}: {}", line_of(parser),
                                        XML_ErrorString(XML_GetErrorCode(parser.get())));
  if (!handler.has_content()) throw Error(ErrorKind::bad_data, fault);
  notes.push_back(fmt::format("T{}. What stands behind it is missing.", fault.substr(1)));
  return notes;
}

std::string root_of(std::string_view bytes) {
  std::string ascii;
  for (const char c : bytes) {
    if (c > 0) ascii += c;  // drops byte order marks and the zeros of UTF-16
  }
  std::string_view rest = trimmed(ascii);
  while (rest.size() > 1 && rest[0] == '<') {
    if (rest[1] != '?' && rest[1] != '!') {
      const std::size_t end = rest.find_first_of(" \t\r\n/>", 1);
      return std::string(local_name(rest.substr(1, end == std::string_view::npos ? end : end - 1)));
    }
    const std::string_view closing = closing_of(rest);
    const std::size_t end = rest.find(closing);
    if (end == std::string_view::npos) return {};
    rest = trimmed(rest.substr(end + closing.size()));
  }
  return {};
}

}  // namespace aerostat::track
