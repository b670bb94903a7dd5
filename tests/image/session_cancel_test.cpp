// Tests that a render ends soon after a request to stop, and that it reports its progress as often.
// The aim is 100 ms, and 400 ms are asserted, because the machine may be busy with something else.
// The measured times are printed.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <future>
#include <system_error>
#include <thread>

#include "core/error.hpp"
#include "core/stopwatch.hpp"
#include "pictures.hpp"
#include "render/programs.hpp"
#include "support/temporary_folder.hpp"

namespace aerostat::test {
namespace {

namespace fs = std::filesystem;
using render::Progress;
using render::Session;
using render::Stage;

constexpr double kPatience_s = 0.4;

/// Returns the seconds from a request to stop to the end of the render. Another thread makes the
/// request `wait_s` after `stage` is reached.
double seconds_to_stop(Session& session, const scene::Scene& scene, Stage stage, double wait_s) {
  std::stop_source stop;
  std::promise<void> reached;
  bool told = false;
  Stopwatch since_request;
  std::jthread canceller([&, arrival = reached.get_future()] {
    arrival.wait();
    std::this_thread::sleep_for(std::chrono::duration<double>(wait_s));
    since_request.restart();
    stop.request_stop();
  });
  const auto watch = [&](const Progress& progress) {
    if (told || progress.stage < stage) return;
    told = true;
    reached.set_value();
  };
  try {
    session.render(resolved(scene), stop.get_token(), watch);
    if (!told) reached.set_value();
    ADD_FAILURE() << "the render ended before it could be stopped";
    return 0.0;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted) << error.what();
  }
  const double seconds = since_request.seconds();
  std::printf("stopped after %.0f ms\n", 1e3 * seconds);
  return seconds;
}

/// Makes an empty folder for PoCL's kernels before the first call of OpenCL, so that the first
/// build of the process is a real one.
class ColdKernelCache : public testing::Environment {
 public:
  void SetUp() override {
    ::setenv("POCL_CACHE_DIR", folder_.path().c_str(), 1);
    // The device can be cut in two, even on a single core.
    const unsigned cores = std::max(2u, std::thread::hardware_concurrency());
    ::setenv("POCL_MAX_PTHREAD_COUNT", std::to_string(cores).c_str(), 0);
  }

 private:
  TemporaryFolder folder_;
};
const auto* const kColdCache = testing::AddGlobalTestEnvironment(new ColdKernelCache);

TEST(Cancel, WhileTheWorldIsBuiltAndKernelsCompile) {
  Session session(options());
  const auto large = small_scene("snow", {96, 64, 1, 1024});
  EXPECT_LT(seconds_to_stop(session, large, Stage::world, 0.05), kPatience_s);
  const auto small = small_scene("sand-empty", {96, 64, 1, 32});
  EXPECT_LT(seconds_to_stop(session, small, Stage::kernels, 0.05), kPatience_s);
  EXPECT_EQ(session.snapshot().width, 0);
  EXPECT_EQ(session.render(resolved(small)).width, 96) << "the session goes on";
  EXPECT_EQ(session.stats().programs_built, render::kProgramCount)
      << "what compiled meanwhile is used";
}

TEST(Cancel, WhileRaysAreTraced) {
  Session session(options());
  auto endless = small_scene("snow", {640, 360, 4096, 128});
  // A balloon would be built again for a picture of another size.
  endless.balloon.enabled = false;
  EXPECT_LT(seconds_to_stop(session, endless, Stage::rays, 1.5), kPatience_s);
  const image::Film kept = session.snapshot();
  ASSERT_EQ(kept.width, 640) << "what was done stays readable";
  EXPECT_EQ(kept.nan_pixels, 0u);

  auto scene = small_scene("snow");
  scene.balloon.enabled = false;
  const image::Film after = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 0);
  Session fresh(options());
  EXPECT_TRUE(same_bits(after, fresh.render(resolved(scene))))
      << "nothing of the stopped render is left";
}

TEST(Cancel, WhileSeveralDevicesTrace) {
  render::Options two = options();
  two.devices = opencl::select_devices("Portable Computing Language/2");
  Session session(two);
  const auto endless = small_scene("snow", {640, 360, 4096, 128});
  EXPECT_LT(seconds_to_stop(session, endless, Stage::rays, 1.0), kPatience_s);
  EXPECT_EQ(session.snapshot().width, 640);
}

TEST(Cancel, WhileBuffersAreUploaded) {
  Session session(options());
  const auto large = small_scene("snow", {96, 64, 4096, 1024});
  EXPECT_LT(seconds_to_stop(session, large, Stage::upload, 0.01), kPatience_s);

  auto same_world = large;
  same_world.image.spp = 1;
  EXPECT_EQ(session.render(resolved(same_world)).nan_pixels, 0u);
  EXPECT_EQ(session.stats().worlds_built, 0) << "what was built before the stop is kept";
}

TEST(Progress, IsReportedAgainAndAgain) {
  Session session(options());
  std::vector<double> gaps;
  double before = 0.0;
  session.render(resolved(small_scene("snow", {320, 180, 64, 128})), {},
                 [&](const Progress& progress) {
                   if (progress.stage == Stage::rays) gaps.push_back(progress.seconds - before);
                   before = progress.seconds;
                 });
  ASSERT_GT(gaps.size(), 4u);
  std::sort(gaps.begin(), gaps.end());
  std::printf("%zu reports, one after %.0f ms (median), %.0f ms (worst)\n", gaps.size(),
              1e3 * gaps[gaps.size() / 2], 1e3 * gaps.back());
  EXPECT_LT(gaps[gaps.size() / 2], kPatience_s);
}

TEST(Cancel, BeforeItBegins) {
  std::stop_source stop;
  stop.request_stop();
  const Stopwatch watch;
  try {
    shared_session().render(resolved(small_scene("sand-empty")), stop.get_token());
    FAIL() << "rendered";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::interrupted);
  }
}

TEST(Cancel, FromTheProgressCallback) {
  std::stop_source stop;
  int samples = -1;
  const auto scene = small_scene("sand-empty", {96, 64, 256, 64});
  EXPECT_THROW(shared_session().render(resolved(scene), stop.get_token(),
                                       [&](const Progress& progress) {
                                         samples = progress.samples_done;
                                         if (progress.samples_done > 0) stop.request_stop();
                                       }),
               Error);
  EXPECT_LT(samples, 256);
  EXPECT_EQ(shared_session().snapshot().width, 96);
}

}  // namespace
}  // namespace aerostat::test
