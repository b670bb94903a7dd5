#pragma once

#include <QObject>
#include <QTimer>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <future>

namespace aerostat::render {
struct Progress;
}

/// Watches whether the device of a thread still answers. A driver that hangs cannot be stopped: a
/// thread that waits for it never ends. Such a thread is left behind with all that it uses.
namespace aerostat::viewer {

/// Listens for signs of a thread that works on a device. `Busy` and `sign` are for that thread, and
/// all else is for the thread that made this object.
class DeviceWatch {
 public:
  /// Tells that nothing was heard for so many seconds. It is told once until the device answers.
  using Silent = std::function<void(int seconds)>;
  /// Tells that the device answers after all.
  using Answers = std::function<void()>;

  DeviceWatch(Silent silent, Answers answers);
  DeviceWatch(const DeviceWatch&) = delete;
  DeviceWatch& operator=(const DeviceWatch&) = delete;

  /// Signs are expected while this object lives.
  class Busy {
   public:
    explicit Busy(DeviceWatch& watch) : watch_(watch) { watch_.set_busy(true); }
    ~Busy() { watch_.set_busy(false); }
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;

   private:
    DeviceWatch& watch_;
  };
  /// Takes the progress of a render as a sign, unless it tells that no ray was traced since.
  void sign(const render::Progress& progress);

  bool is_silent() const { return is_silent_; }
  /// Tells nothing more.
  void stop() { timer_.stop(); }

 private:
  void set_busy(bool is_busy);
  void look();

  Silent silent_;
  Answers answers_;
  QTimer timer_;
  std::atomic<bool> is_busy_ = false;
  std::atomic<std::uint64_t> signs_ = 0;
  /// The rays at the last sign.
  std::uint64_t rays_ = 0;
  // The next fields belong to the thread that made this object.
  std::uint64_t signs_seen_ = 0;
  int times_silent_ = 0;
  bool is_silent_ = false;
};

/// Waits for the end of a thread that was asked to stop: for some seconds, or for a moment if its
/// device is silent. Returns whether it ended.
bool ends_soon(const std::future<void>& ended, const DeviceWatch& watch);

/// Keeps an object that a thread uses which does not end. The process must then end without
/// destructors, because those of drivers may wait for that thread.
void leave_behind(const void* object);

/// Returns whether anything was left behind.
bool is_anything_left_behind();

}  // namespace aerostat::viewer
