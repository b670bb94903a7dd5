#include "scene/enum_names.hpp"

namespace aerostat::scene::detail {

template <>
std::span<const char* const> enum_names<BiomeKind>() {
  static constexpr const char* kNames[] = {"snow", "tropical", "sand", "meadow"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Season>() {
  static constexpr const char* kNames[] = {"spring", "summer", "autumn"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<TerrainKind>() {
  static constexpr const char* kNames[] = {"mountains", "island", "dunes", "elevation"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<HeightUnit>() {
  static constexpr const char* kNames[] = {"auto", "m", "dm", "cm", "ft", "us-ft"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<TileEncoding>() {
  static constexpr const char* kNames[] = {"auto", "terrarium", "terrain-rgb"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Voids>() {
  static constexpr const char* kNames[] = {"land", "sea"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<InlandWater>() {
  static constexpr const char* kNames[] = {"auto", "none"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<CoverClass>() {
  static constexpr const char* kNames[] = {"woods", "shrub",    "meadow",  "crops", "bare",
                                           "snow",  "built_up", "wetland", "water"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<CoverScheme>() {
  static constexpr const char* kNames[] = {"auto", "worldcover", "nlcd", "corine"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<SampleType>() {
  static constexpr const char* kNames[] = {"auto",   "uint8", "int8",    "uint16", "int16",
                                           "uint32", "int32", "float32", "float64"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<FractalKind>() {
  static constexpr const char* kNames[] = {"fbm", "ridged"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<HeightReference>() {
  static constexpr const char* kNames[] = {"sea", "ground", "balloon"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Mood>() {
  static constexpr const char* kNames[] = {"none", "dawn",  "noon",  "golden",
                                           "dusk", "night", "storm", "mist"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<View>() {
  static constexpr const char* kNames[] = {"outside", "basket"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Lens>() {
  static constexpr const char* kNames[] = {"pinhole", "thin_lens", "panorama", "orthographic"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Shading>() {
  static constexpr const char* kNames[] = {"flat", "gouraud", "phong"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Surfaces>() {
  static constexpr const char* kNames[] = {"full", "plain"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Integrator>() {
  static constexpr const char* kNames[] = {"local", "path"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Filter>() {
  static constexpr const char* kNames[] = {"box", "tent", "gaussian"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Easing>() {
  static constexpr const char* kNames[] = {"linear", "smooth", "hold"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<CameraMode>() {
  static constexpr const char* kNames[] = {"scene", "path", "orbit", "chase", "basket", "ground"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<CameraLook>() {
  static constexpr const char* kNames[] = {"usual", "target", "balloon", "ahead"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Pattern>() {
  static constexpr const char* kNames[] = {"stripes", "chevrons", "spiral", "rainbow", "checker"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Palette>() {
  static constexpr const char* kNames[] = {"ember",   "lagoon", "spectrum", "glacier",
                                           "orchard", "plum",   "regatta",  "meadow"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<Quality>() {
  static constexpr const char* kNames[] = {"draft", "standard", "final"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<UpAxis>() {
  static constexpr const char* kNames[] = {"y", "z"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<ArtworkWrap>() {
  static constexpr const char* kNames[] = {"whole", "band", "motif", "gores"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<PlacedOn>() {
  static constexpr const char* kNames[] = {"land", "water", "anywhere"};
  return kNames;
}

template <>
std::span<const char* const> enum_names<PlantPlace>() {
  static constexpr const char* kNames[] = {"woods", "open", "anywhere"};
  return kNames;
}

}  // namespace aerostat::scene::detail
