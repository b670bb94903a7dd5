#pragma once

#include <string>
#include <vector>

#include "core/math.hpp"
#include "scene/scene.hpp"
#include "world/world.hpp"

/// Reads a scene as another program would see it: from the file that `export` writes and the camera
/// that `dump` prints.
namespace aerostat::test {

struct ExportedWorld {
  std::vector<vec3> positions;
  /// The linear colour of each vertex.
  std::vector<vec3> colors;
  std::vector<uvec3> triangles;
  /// The object of each triangle.
  std::vector<std::uint32_t> objects;
};

/// Reads back the binary PLY of a scene's world. `instances` says whether plants are written out,
/// too.
ExportedWorld exported_world(const scene::Scene& scene,
                             world::Placed instances = world::Placed::left_out);

/// Computes rays through the middles of pixels in double precision, from the words of the manual:
/// vertical field of view, square pixels, y up and row 0 at the top, or a panorama, or parallel
/// rays.
class DumpedCamera {
 public:
  explicit DumpedCamera(const scene::Scene& scene);

  /// Returns the origin of the ray through the middle of pixel (x, y).
  dvec3 origin(int x, int y) const;
  /// Returns the unit direction through the middle of pixel (x, y).
  dvec3 direction(int x, int y) const;
  /// Returns the unit direction through a point of the picture, in pixels from its top left corner.
  /// The lens must be a pinhole.
  dvec3 direction_through(const dvec2& point) const;

 private:
  /// Returns the offset of a point of the picture from its middle, to the right and up, in halves
  /// of the picture's height.
  dvec2 from_middle(const dvec2& point) const;

  std::string lens_;
  dvec3 origin_, forward_, right_, up_;
  int width_ = 0, height_ = 0;
  /// The tangent of half the vertical field of view.
  double tangent_ = 0.0;
  /// Half the height in metres of a picture with parallel rays.
  double half_height_m_ = 0.0;
};

}  // namespace aerostat::test
