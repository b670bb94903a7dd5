#pragma once

#include <cstddef>
#include <span>

#include "scene/artwork.hpp"
#include "scene/balloon.hpp"
#include "scene/film.hpp"
#include "scene/land.hpp"
#include "scene/light.hpp"
#include "scene/picture.hpp"
#include "scene/placed_model.hpp"

namespace aerostat::scene::detail {

/// Returns the words that scene files use for the values of an enum, in the order of the values.
template <class Enum>
std::span<const char* const> enum_names();

template <>
std::span<const char* const> enum_names<BiomeKind>();
template <>
std::span<const char* const> enum_names<Season>();
template <>
std::span<const char* const> enum_names<TerrainKind>();
template <>
std::span<const char* const> enum_names<SampleType>();
template <>
std::span<const char* const> enum_names<Voids>();
template <>
std::span<const char* const> enum_names<TileEncoding>();
template <>
std::span<const char* const> enum_names<HeightUnit>();
template <>
std::span<const char* const> enum_names<FractalKind>();
template <>
std::span<const char* const> enum_names<HeightReference>();
template <>
std::span<const char* const> enum_names<Mood>();
template <>
std::span<const char* const> enum_names<View>();
template <>
std::span<const char* const> enum_names<Lens>();
template <>
std::span<const char* const> enum_names<Shading>();
template <>
std::span<const char* const> enum_names<Integrator>();
template <>
std::span<const char* const> enum_names<Filter>();
template <>
std::span<const char* const> enum_names<Pattern>();
template <>
std::span<const char* const> enum_names<Palette>();
template <>
std::span<const char* const> enum_names<Quality>();
template <>
std::span<const char* const> enum_names<UpAxis>();
template <>
std::span<const char* const> enum_names<ArtworkWrap>();
template <>
std::span<const char* const> enum_names<PlacedOn>();
template <>
std::span<const char* const> enum_names<PlantPlace>();

/// Returns the word that scene files use for a value of an enum.
template <class Enum>
const char* word_of(Enum value) {
  return enum_names<Enum>()[static_cast<std::size_t>(value)];
}

}  // namespace aerostat::scene::detail
