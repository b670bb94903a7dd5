#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "asset/files.hpp"
#include "asset/json_value.hpp"

namespace aerostat::asset {

/// A piece of a buffer.
struct GltfView {
  std::string_view bytes;
  std::size_t offset = 0;             // in the buffer
  std::optional<std::size_t> stride;  // bytes from element to element, if the file says it
};

/// Returns the bytes of a data URI that is encoded in base64. `where` is its place in the file.
std::string bytes_of_data_uri(std::string_view uri, const JsonValue& where);

/// The buffers of a glTF file and their views.
class GltfBuffers {
 public:
  /// Reads all buffers. `binary` is the binary piece of a .glb. Throws Error{bad_data} for a buffer
  /// or a view that is not there, and if all have more than `most_bytes`.
  GltfBuffers(const JsonValue& root, std::optional<std::string_view> binary, const Files& files,
              std::uint64_t most_bytes);

  std::size_t view_count() const { return views_.size(); }
  const GltfView& view(std::size_t i) const { return views_[i]; }

  /// Returns the bytes of a URI, which is a data URI or the name of a file beside the model.
  std::string_view bytes_of_uri(const JsonValue& uri);

 private:
  std::string_view read_buffer(const JsonValue& buffer, std::size_t i,
                               std::optional<std::string_view> binary);
  GltfView read_view(const JsonValue& view) const;
  std::string_view keep(std::string bytes, const JsonValue& where);

  const Files& files_;
  std::uint64_t bytes_left_;
  std::deque<std::string> kept_;  // what the buffers point into
  std::map<std::string, std::string_view> by_name_;
  std::vector<std::string_view> buffers_;
  std::vector<GltfView> views_;
};

}  // namespace aerostat::asset
