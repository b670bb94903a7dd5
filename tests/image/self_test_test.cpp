// Tests that a device which works passes the self-test, whatever its lanes.
#include "render/self_test.hpp"

#include "pictures.hpp"

namespace aerostat::test {
namespace {

TEST(SelfTest, IsPassedAtEveryWidthByBothIntegrators) {
  for (const int lanes : {1, 4, 8, 16}) {
    for (const auto integrator : {scene::Integrator::local, scene::Integrator::path}) {
      render::SelfTest test;
      test.lanes = lanes;
      test.integrator = integrator;
      EXPECT_EQ(render::fault_of(devices().front(), test), "")
          << lanes << " lanes, integrator " << static_cast<int>(integrator);
    }
  }
}

}  // namespace
}  // namespace aerostat::test
