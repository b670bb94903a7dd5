#pragma once

#include <optional>
#include <string>

#include "scene/film.hpp"

namespace aerostat::scene {

/// What a key can do with a value.
enum class KeyKind {
  number,   // it goes evenly from key to key
  integer,  // as a number, and is rounded
  angle,    // a full circle, which takes the shorter way
  numbers,  // an array of numbers
  word,     // it holds until the next key
  time      // a time of day as text
};

/// Returns what keys can do with the value at a JSON pointer, or nothing for a value that cannot
/// move: one that a scene does not have, lists of objects, names of files, the size of the picture
/// and the film itself.
std::optional<KeyKind> key_kind(const std::string& pointer);

namespace detail {

/// Throws BadScene if a film contradicts itself: if times or heights do not rise, if a path has no
/// points, or if keys name what cannot move or give values that the scene cannot have.
void check_film(const Film& film, const std::string& name);

}  // namespace detail
}  // namespace aerostat::scene
