#include "viewer/device_watch.hpp"

#include <utility>
#include <vector>

#include "core/duration.hpp"
#include "core/environment.hpp"
#include "render/session.hpp"

namespace aerostat::viewer {
namespace {

constexpr std::chrono::milliseconds kLookEvery(250);
/// The seconds without a sign after which a device is called silent. Launches take 0.03 s, and the
/// user may go on waiting. Chosen by eye.
constexpr double kSilence_s = 30.0;
/// How long an end is waited for. A thread may still be compiling kernels, which is lost then.
/// Chosen by eye.
constexpr std::chrono::seconds kPatience(10);
constexpr std::chrono::milliseconds kMoment(200);

/// Returns the seconds of silence, or 0 if devices may be silent without limit.
double silence_s() {
  const auto text = environment_variable(kDeviceTimeoutVariable);
  if (!text) return kSilence_s;
  return *text == "0" ? 0.0 : duration_s(*text).value_or(kSilence_s);
}

std::vector<const void*>& left_behind() {
  static auto& all = *new std::vector<const void*>;
  return all;
}

}  // namespace

DeviceWatch::DeviceWatch(Silent silent, Answers answers)
    : silent_(std::move(silent)), answers_(std::move(answers)) {
  QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
  if (silence_s() > 0.0) timer_.start(kLookEvery);
}

void DeviceWatch::set_busy(bool is_busy) {
  is_busy_ = is_busy;
  ++signs_;
}

void DeviceWatch::sign(const render::Progress& progress) {
  if (progress.stage == render::Stage::rays && progress.rays == rays_) return;
  rays_ = progress.rays;
  ++signs_;
}

/// Counts looks and not seconds, so that a process that was stopped for a while is not taken for
/// one whose device is lost.
void DeviceWatch::look() {
  const std::uint64_t signs = signs_;
  if (signs != signs_seen_ || !is_busy_) {
    signs_seen_ = signs;
    times_silent_ = 0;
    if (std::exchange(is_silent_, false)) answers_();
    return;
  }
  ++times_silent_;
  const double seconds = times_silent_ * std::chrono::duration<double>(kLookEvery).count();
  if (seconds < silence_s() || std::exchange(is_silent_, true)) return;
  silent_(static_cast<int>(seconds));
}

bool ends_soon(const std::future<void>& ended, const DeviceWatch& watch) {
  const auto patience = watch.is_silent() ? kMoment : std::chrono::milliseconds(kPatience);
  return ended.wait_for(patience) == std::future_status::ready;
}

void leave_behind(const void* object) {
  left_behind().push_back(object);
}

bool is_anything_left_behind() {
  return !left_behind().empty();
}

}  // namespace aerostat::viewer
