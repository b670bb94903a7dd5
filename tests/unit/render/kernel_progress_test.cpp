// Tests the progress of kernels that are compiled, with a clock of the test's own.
#include "render/kernel_progress.hpp"

#include <gtest/gtest.h>

namespace aerostat::render {
namespace {

TEST(KernelProgress, GrowsWithinStepsAndNeverPastThem) {
  double now_s = 100.0;
  KernelProgress progress([&] { return now_s; });
  EXPECT_EQ(progress.fraction(), 0.0);
  double last = 0.0, done = 0.0;
  for (const double share : {0.5, 0.3, 0.2}) {
    progress.begin(share);
    EXPECT_EQ(progress.fraction(), done);
    for (int second = 0; second < 1000; ++second) {
      now_s += 1.0;
      EXPECT_GT(progress.fraction(), last);
      EXPECT_LT(progress.fraction(), done + share);
      last = progress.fraction();
    }
    done += share;
  }
  progress.finish();
  EXPECT_EQ(progress.fraction(), 1.0);
  now_s += 100.0;
  EXPECT_EQ(progress.fraction(), 1.0);
}

TEST(KernelProgress, TakesWhatIsDoneAtOnceAsDone) {
  KernelProgress progress([] { return 0.0; });
  progress.begin(0.25);
  progress.begin(0.25);
  EXPECT_EQ(progress.fraction(), 0.25);
  progress.begin(0.5);
  EXPECT_EQ(progress.fraction(), 0.5);
}

}  // namespace
}  // namespace aerostat::render
