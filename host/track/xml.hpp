#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// Reads XML for the formats of tracks. Names are compared without their namespace, because files
/// declare it in many ways or not at all.
namespace aerostat::track {

/// The attributes of an element.
class XmlAttributes {
 public:
  /// `pairs` holds names and values in turn and ends with a null pointer.
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}

  /// Returns the value of an attribute, if the element has it.
  std::optional<std::string_view> value(std::string_view name) const;

 private:
  const char* const* pairs_;
};

/// Receives the elements of a file in their order.
class XmlHandler {
 public:
  virtual ~XmlHandler() = default;
  virtual void begin(std::string_view name, const XmlAttributes& attributes) = 0;
  /// `text` is what stands directly before the end of the element.
  virtual void end(std::string_view name, std::string_view text) = 0;
  /// Returns whether something worth keeping was read, should the rest of the file be damaged.
  virtual bool has_content() const = 0;
};

/// Reads a whole file. A fault ends the reading. If the handler has content by then, the fault
/// becomes one of the notes that this function returns. Throws Error{bad_data} otherwise, and
/// always if the file declares entities or is nested deeper than 100 elements.
std::vector<std::string> read_xml(std::string_view bytes, XmlHandler& handler);

/// Returns the name of the first element of a file in any encoding, without its namespace, or an
/// empty string if the bytes are not the beginning of an XML file.
std::string root_of(std::string_view bytes);

/// Returns the part of an XML name behind its prefix.
std::string_view local_name(std::string_view name);

}  // namespace aerostat::track
