#pragma once

#include <optional>
#include <string>

#include "core/math.hpp"
#include "scene/up_axis.hpp"

/// What a scene file says of an envelope beside its pattern: pictures on the cloth, and a shape of
/// its own.
namespace aerostat::scene {

/// How a picture lies on the envelope.
enum class ArtworkWrap {
  whole,  // once around, from the mouth to the crown
  band,   // all around, between two heights
  motif,  // at a place, in its own proportions
  gores   // as drawn on the template of the unrolled gores
};

/// The most pictures on one envelope.
inline constexpr int kMostArtwork = 16;

/// A picture on the envelope of a balloon. Heights count along the cloth from the mouth.
struct Artwork {
  std::string file;  // PNG, JPEG or SVG
  ArtworkWrap wrap = ArtworkWrap::whole;
  double around_deg = 0.0;           // of its middle from the heading, clockwise from above
  std::optional<double> height_m{};  // of the middle of a motif; default: the widest place
  std::optional<double> width_m{};   // of a motif; default: 0.4 diameters
  std::optional<dvec2> heights_m{};  // of the ends of a band; default: a fifth around the widest
  std::optional<int> repeat{};       // copies around; default: a band's proportions are kept

  bool operator==(const Artwork&) const = default;
};

/// An envelope of a special shape, whose cloth is the surface of a model from a file.
struct EnvelopeModel {
  std::string file;
  UpAxis up = UpAxis::y;
  std::optional<double> height_m{};  // of the envelope; default: that of a usual one
  double turn_deg = 0.0;             // from the heading, clockwise from above

  bool operator==(const EnvelopeModel&) const = default;
};

}  // namespace aerostat::scene
