#pragma once

#include <string>
#include <vector>

#include "core/math.hpp"
#include "scene/scene.hpp"

/// A scene as another program would see it: the file that `export` writes and the camera that
/// `dump` tells.
namespace aerostat::test {

struct ExportedWorld {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;
  std::vector<std::uint32_t> objects;  // per triangle
};

/// Reads back the binary PLY of a scene's world.
ExportedWorld exported_world(const scene::Scene& scene);

/// Rays through the middles of pixels, in double precision, by the words of the manual: vertical
/// field of view, square pixels, y up, row 0 at the top; or a panorama, or parallel rays.
class DumpedCamera {
 public:
  explicit DumpedCamera(const scene::Scene& scene);

  /// Where the ray through the middle of pixel (x, y) begins.
  dvec3 origin(int x, int y) const;
  /// Unit direction through the middle of pixel (x, y).
  dvec3 direction(int x, int y) const;

 private:
  /// Of the middle of pixel (x, y) from the picture's, to the right and up, in halves of the
  /// picture's height.
  dvec2 from_middle(int x, int y) const;

  std::string lens_;
  dvec3 origin_, forward_, right_, up_;
  int width_ = 0, height_ = 0;
  double tangent_ = 0.0;        // of half the vertical field of view
  double half_height_m_ = 0.0;  // of a picture by parallel rays
};

}  // namespace aerostat::test
