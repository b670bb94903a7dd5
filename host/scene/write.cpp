#include "scene/write.hpp"

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "scene/enum_names.hpp"
#include "scene/fields.hpp"
#include "scene/io.hpp"

namespace aerostat::scene {

namespace detail {

namespace {

template <class T>
bool is_given(const T&) {
  return true;
}

template <class T>
bool is_given(const std::optional<T>& value) {
  return value.has_value();
}

template <class T>
OrderedJson written(const T& value);

OrderedJson written(const vec3& v) {
  return OrderedJson::array({shortest(v.x), shortest(v.y), shortest(v.z)});
}

OrderedJson written(const std::string& text) {
  return text;
}

OrderedJson written(const KeyValue& value) {
  if (value.is_array) return value.numbers;
  if (value.numbers.empty()) return value.text;
  return value.numbers[0];
}

OrderedJson written(const dvec2& v) {
  return OrderedJson::array({v.x, v.y});
}

OrderedJson written(const dvec3& v) {
  return OrderedJson::array({v.x, v.y, v.z});
}

OrderedJson written(const double (&v)[2]) {
  return OrderedJson::array({v[0], v[1]});
}

template <class T>
OrderedJson written(const std::optional<T>& value) {
  return written(*value);
}

template <class T>
OrderedJson written(const std::vector<T>& values) {
  OrderedJson result = OrderedJson::array();
  for (const T& value : values) result.push_back(written(value));
  return result;
}

OrderedJson written(const std::array<Material, kMaterialCount>& materials) {
  OrderedJson result = OrderedJson::object();
  for (std::size_t i = 0; i < kMaterialCount; ++i) {
    result[material_name(static_cast<MaterialId>(i))] = written(materials[i]);
  }
  return result;
}

template <class T>
OrderedJson written(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return enum_names<T>()[static_cast<std::size_t>(value)];
  } else if constexpr (std::is_arithmetic_v<T>) {
    return value;
  } else {
    OrderedJson result = OrderedJson::object();
    for_each_member<T>([&](const auto& field) {
      if (is_given(value.*field.member)) result[field.key] = written(value.*field.member);
    });
    return result;
  }
}

}  // namespace

OrderedJson to_json(const Scene& scene) {
  OrderedJson result = {{"version", 1}};
  result.update(written(scene));
  return result;
}

}  // namespace detail

std::string write_text(const Scene& scene) {
  return detail::print_json(detail::to_json(scene));
}

}  // namespace aerostat::scene
