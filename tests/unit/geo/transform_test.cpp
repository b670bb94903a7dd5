#include "geo/transform.hpp"

#include <gtest/gtest.h>

namespace aerostat::geo {
namespace {

TEST(CurvatureDrop, HidesSeventyMetresAtThirtyKilometres) {
  EXPECT_NEAR(curvature_drop(30000.0), 61.45, 0.05);  // 70.63 m without refraction
  EXPECT_EQ(curvature_drop(0.0), 0.0);
}

}  // namespace
}  // namespace aerostat::geo
