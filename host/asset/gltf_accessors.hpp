#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "asset/gltf_buffers.hpp"
#include "asset/json_value.hpp"

namespace aerostat::asset {

/// The types of stored numbers. The values are the codes that glTF uses.
enum class GltfNumber : std::uint32_t {
  int8 = 5120,
  uint8 = 5121,
  int16 = 5122,
  uint16 = 5123,
  uint32 = 5125,
  float32 = 5126
};

/// A list of elements that have the same number of components.
struct GltfAccessor {
  std::size_t count = 0;
  std::size_t components = 1;
  std::string type;  // such as "VEC3"
  GltfNumber number = GltfNumber::float32;
  bool normalized = false;       // integers stand for 0 to 1, or for -1 to 1
  std::optional<GltfView> view;  // without one, all numbers are 0
  std::size_t offset = 0, stride = 0;

  /// Elements that replace those of the view: glTF calls this a sparse accessor.
  struct Sparse {
    std::size_t count = 0;
    GltfNumber index_type = GltfNumber::uint32;
    GltfView indices, values;
    std::size_t index_offset = 0, value_offset = 0;
    std::string pointer;
  };
  std::optional<Sparse> sparse;
  bool is_of_float() const { return number == GltfNumber::float32; }
};

/// The accessors of a glTF file. Their counts come from the file, so a caller checks the count
/// against its limits before it reads an accessor.
class GltfAccessors {
 public:
  /// Checks all accessors. Throws Error{bad_data} if one of them reaches out of its view.
  GltfAccessors(const JsonValue& root, const GltfBuffers& buffers);

  std::size_t size() const { return accessors_.size(); }
  const GltfAccessor& operator[](std::size_t i) const { return accessors_[i]; }

  /// Returns the accessor that an index of the document names.
  const GltfAccessor& at(const JsonValue& index) const {
    return accessors_[index.index(accessors_.size(), "accessors")];
  }

 private:
  std::vector<GltfAccessor> accessors_;
};

/// Returns all numbers of an accessor, element by element. Normalized integers become fractions.
std::vector<float> reals_of(const GltfAccessor& accessor);

/// Returns all numbers of an accessor of integers.
std::vector<std::uint32_t> integers_of(const GltfAccessor& accessor);

/// Returns the numbers of the elements with these indices. The indices must be in ascending order
/// and less than the count of the accessor.
std::vector<float> reals_of(const GltfAccessor& accessor, std::span<const std::uint32_t> elements);
std::vector<std::uint32_t> integers_of(const GltfAccessor& accessor,
                                       std::span<const std::uint32_t> elements);

}  // namespace aerostat::asset
