#pragma once

#include <tuple>

#include "scene/about.hpp"

/// The parts of the tables that describe the scene's structs.
namespace aerostat::scene::detail {

/// A member of the struct S with its key in scene files.
template <class S, class T>
struct Field {
  const char* key;
  T S::*member;
  About about;
};

/// A key that scene files may have and that is read apart from the table.
template <class T>
struct OnlyRead {
  const char* key;
  About about;
};

/// The fields of a struct, in the order of the file.
template <class... Fields>
struct Table {
  const char* text;  // the text of the object
  std::tuple<Fields...> fields;
};

template <class S, class T>
constexpr Field<S, T> field(const char* key, T S::*member, const About& about = {}) {
  return {key, member, about};
}

template <class T>
constexpr OnlyRead<T> only_read(const char* key, const About& about) {
  return {key, about};
}

template <class... Fields>
constexpr Table<Fields...> table(const char* text, Fields... fields) {
  return {text, {fields...}};
}

/// The table of the struct S. There is a specialisation for each struct of scene.hpp.
template <class S>
inline constexpr auto kTable = nullptr;

/// Calls `visit` for each field of S, in the order of the file, with a Field or an OnlyRead.
template <class S, class Visit>
void for_each_field(Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field), ...); }, kTable<S>.fields);
}

/// Calls `visit` for each field of S that is a member of it, in the order of the file.
template <class S, class Visit>
void for_each_member(Visit&& visit) {
  for_each_field<S>([&]<class F>(const F& field) {
    if constexpr (requires { field.member; }) visit(field);
  });
}

}  // namespace aerostat::scene::detail
