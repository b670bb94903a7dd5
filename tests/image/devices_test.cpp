// Tests several devices that render one picture. They are parts of PoCL's device, which is
// available everywhere.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <memory>
#include <numeric>
#include <optional>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "opencl/status.hpp"
#include "pictures.hpp"
#include "render/film_sums.hpp"
#include "render/row_queue.hpp"
#include "render/test_hooks.hpp"

namespace aerostat::test {
namespace {

using render::Crop;
using render::RowQueue;
using render::RowRun;
using render::Session;

/// Gives PoCL's device three compute units, however many cores there are, so that its halves have
/// two and one. It must be set before the first call of OpenCL.
class ThreeComputeUnits : public testing::Environment {
 public:
  void SetUp() override { ::setenv("POCL_MAX_PTHREAD_COUNT", "3", 1); }
};
const auto* const kThreeUnits = testing::AddGlobalTestEnvironment(new ThreeComputeUnits);

/// The platform whose device can be cut and has as many compute units as requested. Other drivers
/// for a CPU do not promise this.
const std::string kPocl = "Portable Computing Language";

render::Options on(const std::string& selector) {
  render::Options options;
  options.devices = opencl::select_devices(selector);
  options.guides = true;
  return options;
}

Session& whole() {
  static auto& session = *new Session(on(kPocl));
  return session;
}

Session& halves() {
  static auto& session = *new Session(on(kPocl + "/2"));
  return session;
}

/// Returns the bytes of buffers on the device that has the most of them.
std::uint64_t most_bytes(const Session& session) {
  std::uint64_t most = 0;
  for (const auto& one : session.stats().devices) most = std::max(most, one.bytes);
  return most;
}

/// Returns the rays of all devices, and the number of devices that traced any.
std::pair<std::uint64_t, int> rays_and_workers(const Session& session) {
  std::uint64_t rays = 0;
  int workers = 0;
  for (const render::DeviceStats& one : session.stats().devices) {
    rays += one.primary_rays;
    workers += one.primary_rays > 0 ? 1 : 0;
  }
  return {rays, workers};
}

TEST(Devices, GiveTheBitsOfOneInPassesOfAnyShape) {
  // The samples need one pass, several passes of one shape, and a last pass with blocks of several
  // rows.
  for (const int spp : {1, 4, 5, 16, 37}) {
    const auto scene = planted_scene("snow", {97, 61, spp, 128});
    const image::Film expected = whole().render(resolved(scene));
    EXPECT_TRUE(same_bits(expected, halves().render(resolved(scene)))) << spp << " spp";
    EXPECT_TRUE(same_bits(expected, halves().snapshot())) << spp << " spp";
    EXPECT_EQ(rays_and_workers(halves()).first, 97u * 61u * static_cast<unsigned>(spp));
    EXPECT_EQ(halves().stats().rays[render::KernelStage::shadow],
              whole().stats().rays[render::KernelStage::shadow]);
  }
}

TEST(Devices, GiveTheBitsOfOneWhateverTheTiles) {
  const auto scene = planted_scene("snow", {97, 61, 21, 128});
  const image::Film expected = whole().render(resolved(scene));
  for (const int pixels : {1, 777}) {
    auto options = on(kPocl + "/3");
    options.tile_pixels = pixels;
    Session session(options);
    EXPECT_TRUE(same_bits(expected, session.render(resolved(scene)))) << pixels << " pixels a tile";
    EXPECT_EQ(rays_and_workers(session).first, 97u * 61u * 21u);
    if (pixels > 1) continue;
    EXPECT_EQ(rays_and_workers(session).second, 3) << "all had something to do";
  }
}

TEST(Devices, GiveTheBitsOfOneInACrop) {
  const auto scene = small_scene("tropical", {97, 61, 18, 128});
  const image::Film all = whole().render(resolved(scene));
  for (const Crop crop : {Crop{13, 7, 61, 44}, Crop{96, 60, 97, 61}, Crop{0, 30, 97, 31}}) {
    EXPECT_TRUE(same_bits(cut(all, crop), halves().render(resolved(scene), {}, {}, crop)))
        << "crop " << crop.x0 << "," << crop.y0 << "," << crop.x1 << "," << crop.y1;
  }
}

TEST(Devices, KeepWhatTheNextSceneCanUse) {
  auto scene = small_scene("snow");
  halves().render(resolved(scene));
  *scene.camera.position += dvec3(-3.0, -1.0, 5.0);
  EXPECT_TRUE(same_bits(whole().render(resolved(scene)), halves().render(resolved(scene))));
  EXPECT_EQ(halves().stats().worlds_built, 0);
  EXPECT_EQ(halves().stats().programs_built, 0);
  scene.balloon.position += dvec3(4.0, 2.0, 1.0);
  EXPECT_TRUE(same_bits(whole().render(resolved(scene)), halves().render(resolved(scene))));
}

TEST(Devices, OfDifferentWidthsGiveRowsOfOneOrTheOther) {
  auto scene = small_scene("snow", {97, 61, 8, 128});
  // A filter would mix rows of both.
  scene.image.filter = scene::Filter::box;
  auto options = on(kPocl + "/2");
  std::vector<image::Film> alone;
  for (const int lanes : {16, 1}) {
    options.lanes = lanes;
    alone.push_back(Session(options).render(resolved(scene)));
  }
  options.lanes = 0;
  options.devices[0].lanes = 16;
  options.devices[1].lanes = 1;
  options.tile_pixels = 1;
  Session session(options);
  const image::Film mixed = session.render(resolved(scene));
  EXPECT_EQ(rays_and_workers(session), (std::pair{std::uint64_t{97u * 61u * 8u}, 2}));
  for (int y = 0; y < 61; ++y) {
    const Crop row{0, y, 97, y + 1};
    const image::Film here = cut(mixed, row);
    EXPECT_TRUE(same_bits(here, cut(alone[0], row)) || same_bits(here, cut(alone[1], row)))
        << "row " << y;
  }
}

TEST(Devices, AreNamedWhenOneFails) {
  const auto scene = small_scene("snow", {320, 180, 4, 128});
  auto options = on(kPocl + "/2");
  options.tile_pixels = 1;
  Session frugal(options);
  const image::Film expected = frugal.render(resolved(scene));
  // The limit is enough for all buffers except the hits of the smallest launches, which are
  // allocated while rays are traced.
  options.memory_limit_bytes = most_bytes(frugal) - 1024;
  Session session(options);
  try {
    session.render(resolved(scene));
    FAIL() << "it fitted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::exhausted);
    const std::string message = error.what();
    EXPECT_NE(message.find("on " + options.devices[0].selector().substr(0, 5)), std::string::npos)
        << message;
    EXPECT_NE(message.find("the hits"), std::string::npos) << message;
  }
  auto smaller = scene;
  smaller.image.width = smaller.image.height = 32;
  EXPECT_TRUE(same_bits(session.render(resolved(smaller)), frugal.render(resolved(smaller))))
      << "the session goes on";
}

TEST(Devices, HalveTheirTilesWhereMemoryIsShort) {
  const auto scene = small_scene("snow", {320, 180, 20, 128});
  auto options = on(kPocl + "/2");
  options.tile_pixels = 1;
  Session frugal(options);
  const image::Film expected = frugal.render(resolved(scene));
  const std::uint64_t most = most_bytes(frugal);
  // The hits of larger launches do not fit.
  options.memory_limit_bytes = most + (1 << 18);
  options.tile_pixels = 1 << 20;
  Session session(options);
  EXPECT_TRUE(same_bits(expected, session.render(resolved(scene))));
  for (const auto& one : session.stats().devices) EXPECT_LE(one.bytes, most + (1 << 18));
}

/// Throws the error of a launch on a device that is lost.
void fail_as_lost() {
  opencl::rethrow("starting the kernel trace_camera_rays",
                  cl::Error(CL_DEVICE_NOT_AVAILABLE, "clEnqueueNDRangeKernel"));
}

/// Renders until `lost` is set, which happens in the middle, and returns the message of the error.
std::string last_words(Session& session, const scene::Scene& scene, std::atomic<bool>& lost) {
  try {
    session.render(resolved(scene), {}, [&](const render::Progress& progress) {
      if (progress.samples_done > 0) lost = true;
    });
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::exhausted);
    return error.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

TEST(Devices, AreLostInWords) {
  std::atomic<bool> lost = false;
  render::TestHooks hooks;
  hooks.before_launch = [&](const opencl::Device&) {
    if (lost) fail_as_lost();
  };
  Session session(on(kPocl), hooks);
  EXPECT_EQ(last_words(session, small_scene("sand-empty", {640, 360, 256, 64}), lost),
            "while starting the kernel trace_camera_rays: the device was lost or stopped working "
            "(CL_DEVICE_NOT_AVAILABLE from clEnqueueNDRangeKernel)");
  EXPECT_EQ(session.snapshot().width, 640) << "what was done stays readable";
  EXPECT_THROW(session.render(resolved(small_scene("snow"))), Error) << "it is still lost";
  lost = false;
  EXPECT_TRUE(same_bits(session.render(resolved(small_scene("snow"))),
                        whole().render(resolved(small_scene("snow")))));
}

TEST(Devices, AreNamedWhenOneIsLost) {
  const auto scene = small_scene("sand-empty", {640, 360, 256, 64});
  for (const std::size_t which : {0u, 1u}) {
    std::atomic<bool> lost = false;
    auto options = on(kPocl + "/2");
    const std::string name = options.devices[which].selector();
    render::TestHooks hooks;
    hooks.before_launch = [&](const opencl::Device& device) {
      if (lost && device.selector() == name) fail_as_lost();
    };
    Session session(options, hooks);
    const std::string words = last_words(session, scene, lost);
    EXPECT_EQ(words.find("on " + opencl::describe(options.devices[which]) + ": while "), 0u)
        << words;
    EXPECT_NE(words.find("the device was lost"), std::string::npos) << words;
    EXPECT_EQ(session.snapshot().width, 640) << "what was done stays readable";
    lost = false;
    const auto next = small_scene("snow");
    EXPECT_TRUE(same_bits(session.render(resolved(next)), whole().render(resolved(next))))
        << "the session goes on";
    options.devices.erase(options.devices.begin() + static_cast<std::ptrdiff_t>(which));
    EXPECT_TRUE(same_bits(Session(options).render(resolved(next)), whole().render(resolved(next))))
        << "and so does one of the device that is left";
  }
}

TEST(Devices, StopTogether) {
  const auto endless = small_scene("sand-empty", {640, 360, 4096, 64});
  std::stop_source stop;
  EXPECT_THROW(halves().render(resolved(endless), stop.get_token(),
                               [&](const render::Progress& progress) {
                                 if (progress.samples_done > 0) stop.request_stop();
                               }),
               Error);
  EXPECT_EQ(halves().snapshot().width, 640) << "what was done stays readable";
  const auto scene = small_scene("snow");
  EXPECT_TRUE(same_bits(whole().render(resolved(scene)), halves().render(resolved(scene))))
      << "nothing is left of it";
}

TEST(Devices, GoOnTogetherWhereOneHasPaused) {
  scene::Scene scene = planted_scene("snow", {97, 61, 40, 128});
  scene.image.adaptive_threshold = 0.02;
  const image::Film expected = whole().render(resolved(scene));
  render::Course course;
  std::optional<render::FilmSums> sums;
  course.wants_pause = [](const render::Progress& now) { return now.samples_done >= 1; };
  course.at_pause = [&](const render::Pause& pause) {
    sums = pause.sums();
    return false;
  };
  auto slow = on(kPocl + "/2");
  slow.tile_pixels = 1;
  render::TestHooks hooks;
  hooks.before_launch = [](const opencl::Device&) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  };
  Session pausing(slow, hooks);
  pausing.render_on(resolved(scene), course);
  ASSERT_TRUE(sums);
  render::Course rest;
  rest.from = std::make_shared<const render::FilmSums>(std::move(*sums));
  EXPECT_TRUE(same_bits(expected, halves().render_on(resolved(scene), rest)));
  EXPECT_TRUE(same_bits(expected, whole().render_on(resolved(scene), rest)));
}

TEST(Devices, NoneIsAnError) {
  EXPECT_THROW(Session(render::Options{}), Error);
}

/// Returns the rows of a run that a device gets from a queue.
std::vector<int> rows_of(const std::optional<RowRun>& run) {
  std::vector<int> rows(run ? static_cast<std::size_t>(run->y1 - run->y0) : 0);
  if (run) std::iota(rows.begin(), rows.end(), run->y0);
  return rows;
}

TEST(RowQueue, GivesOneDeviceWhatItAsksFor) {
  RowQueue queue(10, 20, 1);
  EXPECT_FALSE(queue.next(0, 1, 4)) << "no pass has begun";
  queue.begin_pass();
  EXPECT_EQ(rows_of(queue.next(0, 1, 4)), (std::vector<int>{10, 11, 12, 13}));
  EXPECT_EQ(rows_of(queue.next(0, 1, 4)), (std::vector<int>{14, 15, 16, 17}));
  EXPECT_EQ(rows_of(queue.next(0, 1, 4)), (std::vector<int>{18, 19}));
  EXPECT_FALSE(queue.next(0, 1, 4));
}

TEST(RowQueue, GivesSeveralLessTowardsTheEnd) {
  RowQueue queue(0, 100, 2);
  queue.begin_pass();
  int device = 0, left = 100;
  while (const auto run = queue.next(device, 2, 1000)) {
    const int rows = run->y1 - run->y0;
    EXPECT_EQ(rows, std::min(left, std::max(2, left / 4)));
    left -= rows;
    device = 1 - device;
  }
  EXPECT_EQ(left, 0);
}

TEST(RowQueue, LetsDevicesKeepTheirRowsAndTakeOthersAtTheEnd) {
  RowQueue queue(0, 8, 2);
  queue.begin_pass();
  // Device 0 gets the rows 0 and 1.
  EXPECT_EQ(queue.next(0, 1, 2)->holder, RowQueue::kNobody);
  // Device 1 gets the rows 2 and 3.
  queue.next(1, 2, 2);
  // Device 0 gets the rows 4 and 5.
  queue.next(0, 2, 2);
  // Device 1 gets the rows 6 and 7.
  queue.next(1, 2, 2);
  queue.begin_pass();
  EXPECT_EQ(rows_of(queue.next(1, 4, 4)), (std::vector<int>{2, 3})) << "not further than its own";
  EXPECT_EQ(rows_of(queue.next(1, 4, 4)), (std::vector<int>{6, 7}));
  const auto taken = queue.next(1, 1, 1);
  EXPECT_EQ(rows_of(taken), (std::vector<int>{5})) << "what the other would come to last";
  EXPECT_EQ(taken->holder, 0);
  EXPECT_EQ(rows_of(queue.next(0, 4, 4)), (std::vector<int>{0, 1}));
  EXPECT_EQ(rows_of(queue.next(0, 4, 4)), (std::vector<int>{4}));
  EXPECT_FALSE(queue.next(0, 4, 4));
  std::vector<int> holders;
  for (const RowRun& run : queue.held()) holders.insert(holders.end(), {run.y0, run.holder});
  EXPECT_EQ(holders, (std::vector<int>{0, 0, 2, 1, 4, 0, 5, 1}));
}

TEST(RowQueue, GoesOnWithTheRowsThatWaitedAtAPause) {
  RowQueue queue(10, 30, 1);
  queue.begin_pass(12, 28);
  queue.next(0, 1, 3);
  const std::vector<render::RowRange> waiting = queue.pause();
  ASSERT_EQ(waiting.size(), 1u);
  EXPECT_EQ(std::pair(waiting[0].y0, waiting[0].y1), (std::pair{15, 28}));
  EXPECT_FALSE(queue.next(0, 1, 3)) << "it is paused";
  const std::vector<render::RowRange> some{{13, 14}, {20, 22}};
  queue.hold_all(0);
  queue.begin_pass(some);
  EXPECT_EQ(rows_of(queue.next(0, 1, 3)), std::vector<int>{13});
  EXPECT_EQ(rows_of(queue.next(0, 1, 3)), (std::vector<int>{20, 21}));
  EXPECT_FALSE(queue.next(0, 1, 3));
  EXPECT_TRUE(queue.pause().empty());
}

TEST(RowQueue, IsEmptyWhenClosed) {
  RowQueue queue(0, 8, 2);
  queue.begin_pass();
  queue.next(0, 1, 2);
  queue.close();
  EXPECT_FALSE(queue.next(0, 1, 2));
}

}  // namespace
}  // namespace aerostat::test
