#pragma once

#include <memory>

#include "exported_world.hpp"

namespace aerostat::test {

/// A ray tracer that shares nothing with the product: Embree where it is installed, else brute
/// force over all triangles in double precision.
class Oracle {
 public:
  explicit Oracle(const ExportedWorld& world);
  ~Oracle();

  struct Answer {
    double distance = std::numeric_limits<double>::infinity();
    std::uint32_t object = 0;  // 0: nothing was met
  };
  Answer nearest(const dvec3& origin, const dvec3& direction) const;

  /// Ask every k-th pixel of each row and column only: 1 with Embree.
  static int stride();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat::test
