#pragma once

#include <memory>

#include "exported_world.hpp"

namespace aerostat::test {

/// A ray tracer that shares no code with the product. It uses Embree if it is installed, else brute
/// force over all triangles in double precision.
class Oracle {
 public:
  explicit Oracle(const ExportedWorld& world);
  ~Oracle();

  struct Answer {
    double distance = std::numeric_limits<double>::infinity();
    /// The object that was hit, or 0 if nothing was hit.
    std::uint32_t object = 0;
    /// The triangle that was hit.
    std::size_t triangle = 0;
  };
  Answer nearest(const dvec3& origin, const dvec3& direction) const;

  /// Returns the step between the pixels of a row or a column that should be tested. It is 1 with
  /// Embree.
  static int stride();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::test
