#include "asset/gltf_accessors.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <string_view>

#include <fmt/format.h>

#include "asset/bytes.hpp"
#include "asset/words.hpp"

namespace aerostat::asset {
namespace {

struct TypeName {
  std::string_view name;
  std::size_t components;
  std::size_t columns;  // of a matrix, each of which begins at a multiple of 4 bytes
};

constexpr std::array<TypeName, 7> kTypes = {{{"SCALAR", 1, 1},
                                             {"VEC2", 2, 1},
                                             {"VEC3", 3, 1},
                                             {"VEC4", 4, 1},
                                             {"MAT2", 4, 2},
                                             {"MAT3", 9, 3},
                                             {"MAT4", 16, 4}}};

std::size_t bytes_of(GltfNumber number) {
  switch (number) {
    case GltfNumber::int8:
    case GltfNumber::uint8:
      return 1;
    case GltfNumber::int16:
    case GltfNumber::uint16:
      return 2;
    case GltfNumber::uint32:
    case GltfNumber::float32:
      break;
  }
  return 4;
}

GltfNumber number_of(const JsonValue& value) {
  const std::uint64_t code = value.whole();
  if (code != 5124 && code >= 5120 && code <= 5126) return static_cast<GltfNumber>(code);
  value.fail("5120, 5121, 5122, 5123, 5125 or 5126");
}

/// Throws unless `count` elements lie in a view.
void require_room(const JsonValue& where, const GltfView& view, std::uint64_t offset,
                  std::uint64_t count, std::size_t stride, std::size_t element) {
  const std::uint64_t room = view.bytes.size();
  const bool fits = offset <= room && element <= room - offset &&
                    (count - 1) <= (room - offset - element) / stride;
  if (fits) return;
  where.fail(fmt::format("{} elements from byte {}", count, offset),
             fmt::format("what lies in the {} bytes of the view", room));
}

void require_aligned(const JsonValue& where, const GltfView& view, std::uint64_t offset,
                     GltfNumber number) {
  const std::size_t size = bytes_of(number);
  if (offset % size == 0 && (view.offset + offset) % size == 0) return;
  where.fail(fmt::format("numbers at byte {} of the buffer", view.offset + offset),
             fmt::format("a multiple of their {} bytes", size));
}

const GltfView& view_at(const JsonValue& index, const GltfBuffers& buffers) {
  return buffers.view(index.index(buffers.view_count(), "bufferViews"));
}

GltfAccessor::Sparse read_sparse(const JsonValue& sparse, const GltfAccessor& accessor,
                                 std::size_t element, const GltfBuffers& buffers) {
  GltfAccessor::Sparse result;
  const std::uint64_t count = sparse["count"].whole();
  if (count == 0 || count > accessor.count) {
    sparse["count"].fail(fmt::format("1 to {}, the number of elements", accessor.count));
  }
  result.count = static_cast<std::size_t>(count);
  result.pointer = sparse.pointer();
  const JsonValue indices = sparse["indices"], values = sparse["values"];
  result.index_type = number_of(indices["componentType"]);
  const bool is_unsigned = result.index_type == GltfNumber::uint8 ||
                           result.index_type == GltfNumber::uint16 ||
                           result.index_type == GltfNumber::uint32;
  if (!is_unsigned) indices["componentType"].fail("5121, 5123 or 5125");
  result.indices = view_at(indices["bufferView"], buffers);
  result.values = view_at(values["bufferView"], buffers);
  if (result.indices.stride) indices["bufferView"].fail("a view without byteStride");
  if (result.values.stride) values["bufferView"].fail("a view without byteStride");
  const std::uint64_t index_offset = indices["byteOffset"].whole(0);
  const std::uint64_t value_offset = values["byteOffset"].whole(0);
  const std::size_t index_bytes = bytes_of(result.index_type);
  require_room(indices, result.indices, index_offset, count, index_bytes, index_bytes);
  require_room(values, result.values, value_offset, count, element, element);
  require_aligned(indices, result.indices, index_offset, result.index_type);
  require_aligned(values, result.values, value_offset, accessor.number);
  result.index_offset = static_cast<std::size_t>(index_offset);
  result.value_offset = static_cast<std::size_t>(value_offset);
  return result;
}

/// Returns the bytes from the first to the last number of an element.
std::size_t element_bytes(const TypeName& type, GltfNumber number) {
  const std::size_t column = type.components / type.columns * bytes_of(number);
  const std::size_t padded = (column + 3) / 4 * 4;
  return type.columns == 1 ? column : padded * (type.columns - 1) + column;
}

GltfAccessor read_accessor(const JsonValue& value, const GltfBuffers& buffers) {
  GltfAccessor accessor;
  accessor.number = number_of(value["componentType"]);
  accessor.type = value["type"].text();
  const auto type = std::find_if(kTypes.begin(), kTypes.end(),
                                 [&](const TypeName& each) { return each.name == accessor.type; });
  if (type == kTypes.end()) value["type"].fail("SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3 or MAT4");
  accessor.components = type->components;
  accessor.normalized = value["normalized"].flag(false);
  const bool is_long = accessor.is_of_float() || accessor.number == GltfNumber::uint32;
  if (accessor.normalized && is_long) {
    value["normalized"].fail("false for numbers of this componentType");
  }
  const std::uint64_t count = value["count"].whole();
  if (count == 0) value["count"].fail("at least 1");
  accessor.count = static_cast<std::size_t>(count);
  const std::size_t element = element_bytes(*type, accessor.number);
  const JsonValue view = value["bufferView"], offset = value["byteOffset"];
  if (view.exists()) {
    accessor.view = view_at(view, buffers);
    const std::size_t column = type->columns == 1 ? bytes_of(accessor.number) : 4;
    accessor.stride = accessor.view->stride.value_or((element + column - 1) / column * column);
    if (accessor.stride < element) {
      view.fail(fmt::format("a byteStride of {}", accessor.stride),
                fmt::format("at least the {} bytes of an element", element));
    }
    require_room(value, *accessor.view, offset.whole(0), count, accessor.stride, element);
    require_aligned(value, *accessor.view, offset.whole(0), accessor.number);
    accessor.offset = static_cast<std::size_t>(offset.whole(0));
  } else if (offset.exists()) {
    view.fail("a bufferView, because there is a byteOffset");
  }
  const JsonValue sparse = value["sparse"];
  if (sparse.exists()) accessor.sparse = read_sparse(sparse, accessor, element, buffers);
  return accessor;
}

std::uint32_t integer_at(std::string_view bytes, std::size_t at, GltfNumber number) {
  switch (number) {
    case GltfNumber::uint8:
      return little_at<std::uint8_t>(bytes, at);
    case GltfNumber::uint16:
      return little_at<std::uint16_t>(bytes, at);
    default:
      return little_at<std::uint32_t>(bytes, at);
  }
}

float real_at(std::string_view bytes, std::size_t at, GltfNumber number, bool normalized) {
  const auto scaled = [&](float value, float most) {
    return normalized ? std::max(value / most, -1.0f) : value;
  };
  switch (number) {
    case GltfNumber::int8:
      return scaled(little_at<std::int8_t>(bytes, at), 127.0f);
    case GltfNumber::uint8:
      return scaled(little_at<std::uint8_t>(bytes, at), 255.0f);
    case GltfNumber::int16:
      return scaled(little_at<std::int16_t>(bytes, at), 32767.0f);
    case GltfNumber::uint16:
      return scaled(little_at<std::uint16_t>(bytes, at), 65535.0f);
    case GltfNumber::uint32:
      return static_cast<float>(little_at<std::uint32_t>(bytes, at));
    case GltfNumber::float32:
      break;
  }
  return little_at<float>(bytes, at);
}

/// Calls `take` for each sparse element, with the index of the element and the offset of its first
/// byte in the view of the values.
template <class Take>
void each_sparse(const GltfAccessor& accessor, const Take& take) {
  if (!accessor.sparse) return;
  const GltfAccessor::Sparse& sparse = *accessor.sparse;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const std::size_t place = sparse.index_offset + i * bytes_of(sparse.index_type);
    const std::uint32_t index = integer_at(sparse.indices.bytes, place, sparse.index_type);
    if (index >= accessor.count || static_cast<std::int64_t>(index) <= last) {
      refuse(fmt::format("{}/indices: found {}, expected indices below {} that rise",
                         sparse.pointer, index, accessor.count));
    }
    last = index;
    take(index, sparse.value_offset + i * accessor.components * bytes_of(accessor.number));
  }
}

/// Reads the numbers of `count` elements. `element(i)` returns the index of the i-th wanted
/// element. `places(index)` returns the values of i that have this index. `read` returns the number
/// at an offset.
template <class Number, class Element, class Places, class Read>
std::vector<Number> numbers_of(const GltfAccessor& accessor, std::size_t count,
                               const Element& element, const Places& places, const Read& read) {
  const std::size_t size = bytes_of(accessor.number), n = accessor.components;
  std::vector<Number> numbers(count * n, Number{});
  const auto fill = [&](std::size_t i, std::string_view bytes, std::size_t at) {
    for (std::size_t k = 0; k < n; ++k) numbers[i * n + k] = read(bytes, at + k * size);
  };
  for (std::size_t i = 0; accessor.view && i < count; ++i) {
    fill(i, accessor.view->bytes, accessor.offset + element(i) * accessor.stride);
  }
  each_sparse(accessor, [&](std::uint32_t index, std::size_t at) {
    for (const std::size_t i : places(index)) fill(i, accessor.sparse->values.bytes, at);
  });
  return numbers;
}

/// Reads all elements.
template <class Number, class Read>
std::vector<Number> all_of(const GltfAccessor& accessor, const Read& read) {
  return numbers_of<Number>(
      accessor, accessor.count, [](std::size_t i) { return i; },
      [](std::uint32_t index) { return std::array<std::size_t, 1>{index}; }, read);
}

/// Reads the elements with these indices, which are in ascending order.
template <class Number, class Read>
std::vector<Number> some_of(const GltfAccessor& accessor, std::span<const std::uint32_t> elements,
                            const Read& read) {
  const auto places = [&](std::uint32_t index) {
    const auto found = std::lower_bound(elements.begin(), elements.end(), index);
    const bool is_wanted = found != elements.end() && *found == index;
    const auto place = static_cast<std::size_t>(found - elements.begin());
    return is_wanted ? std::vector<std::size_t>{place} : std::vector<std::size_t>();
  };
  return numbers_of<Number>(
      accessor, elements.size(), [&](std::size_t i) { return elements[i]; }, places, read);
}

auto reading_reals(const GltfAccessor& accessor) {
  return [&accessor](std::string_view bytes, std::size_t at) {
    return real_at(bytes, at, accessor.number, accessor.normalized);
  };
}

auto reading_integers(const GltfAccessor& accessor) {
  return [&accessor](std::string_view bytes, std::size_t at) {
    return integer_at(bytes, at, accessor.number);
  };
}

}  // namespace

GltfAccessors::GltfAccessors(const JsonValue& root, const GltfBuffers& buffers) {
  const JsonValue accessors = root["accessors"];
  accessors_.reserve(accessors.size());
  for (std::size_t i = 0; i < accessors.size(); ++i) {
    accessors_.push_back(read_accessor(accessors.at(i), buffers));
  }
}

std::vector<float> reals_of(const GltfAccessor& accessor) {
  return all_of<float>(accessor, reading_reals(accessor));
}

std::vector<std::uint32_t> integers_of(const GltfAccessor& accessor) {
  return all_of<std::uint32_t>(accessor, reading_integers(accessor));
}

std::vector<float> reals_of(const GltfAccessor& accessor, std::span<const std::uint32_t> elements) {
  return some_of<float>(accessor, elements, reading_reals(accessor));
}

std::vector<std::uint32_t> integers_of(const GltfAccessor& accessor,
                                       std::span<const std::uint32_t> elements) {
  return some_of<std::uint32_t>(accessor, elements, reading_integers(accessor));
}

}  // namespace aerostat::asset
