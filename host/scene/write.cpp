#include "scene/write.hpp"

#include <type_traits>
#include <utility>

#include "scene/enum_names.hpp"
#include "scene/fields.hpp"
#include "scene/io.hpp"

namespace aerostat::scene {

namespace detail {

namespace {

/// The archive of fields.hpp that writes.
class Writer {
 public:
  template <class T>
  void operator()(const char* key, T& value) {
    result_[key] = written(value);
  }

  template <class T>
  void operator()(const char* key, T& value, bool given) {
    if (given) (*this)(key, value);
  }

  OrderedJson take() { return std::move(result_); }

 private:
  template <class T>
  static OrderedJson written(T& value) {
    if constexpr (std::is_enum_v<T>) {
      return enum_names<T>()[static_cast<std::size_t>(value)];
    } else if constexpr (std::is_arithmetic_v<T>) {
      return value;
    } else {
      Writer inner;
      fields(inner, value);
      return inner.take();
    }
  }

  static OrderedJson written(vec3& v) {
    return OrderedJson::array({shortest(v.x), shortest(v.y), shortest(v.z)});
  }
  static OrderedJson written(dvec2& v) { return OrderedJson::array({v.x, v.y}); }
  static OrderedJson written(dvec3& v) { return OrderedJson::array({v.x, v.y, v.z}); }
  static OrderedJson written(double (&v)[2]) { return OrderedJson::array({v[0], v[1]}); }

  template <class T>
  static OrderedJson written(std::vector<T>& values) {
    OrderedJson result = OrderedJson::array();
    for (T& value : values) result.push_back(written(value));
    return result;
  }

  OrderedJson result_ = OrderedJson::object();
};

}  // namespace

OrderedJson to_json(const Scene& scene) {
  Writer writer;
  int version = 1;
  writer("version", version);
  Scene copy = scene;
  fields(writer, copy);
  return writer.take();
}

}  // namespace detail

std::string write_text(const Scene& scene) {
  return detail::print_json(detail::to_json(scene));
}

}  // namespace aerostat::scene
