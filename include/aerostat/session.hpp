#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <vector>

#include "aerostat/devices.hpp"
#include "aerostat/export.hpp"
#include "aerostat/film.hpp"
#include "aerostat/scene.hpp"

namespace aerostat {

struct SessionOptions {
  /// The devices that render: "auto" (a GPU if there is one, else the CPU), "cpu", "gpu", "0:1",
  /// a part of a name, "all", or several of these with commas between them. If it is empty, the
  /// environment variable AEROSTAT_DEVICE decides, or else "auto".
  std::string device;
  int lanes = 0;  ///< rays of a work-item: 1, 4, 8 or 16; 0: chosen by the device
  std::uint64_t memory_limit_bytes = 0;  ///< limit for buffers on each device; 0: the device's own
  /// Prepares the session for views that move. Plants out of sight are placed too, so that a
  /// camera that turns causes no work. Without this, each single picture is rendered as fast as
  /// possible.
  bool interactive = false;
  /// Whether films hold albedos and normals. Without them, rendering takes less time.
  bool guides = true;
  /// Whether a device is tested when it is used for the first time with its driver: rays with known
  /// answers are compared. That takes the time that kernels take to compile. If a device that is
  /// named fails, the session throws Error{no_device}; in place of one that "auto" stands for, the
  /// next device is taken.
  bool self_test = true;
};

enum class Stage { world, trees, kernels, upload, rays, done };

struct Progress {
  Stage stage = Stage::world;
  double fraction = 0.0;  ///< done share of the stage, 0 to 1
  double seconds = 0.0;   ///< seconds since the render began
};

/// Renders scenes one after the other. It keeps what the next scene can use: meshes, trees,
/// kernels and buffers. A scene that differs only by its camera builds nothing. A session must be
/// used from one thread at a time. Several sessions can be used side by side.
class AEROSTAT_API Session {
 public:
  /// Opens the devices. Throws Error{no_device} if no device fits, and Error{usage} if the
  /// options make no sense.
  explicit Session(const SessionOptions& options = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Renders all samples of the scene. `progress` is called from this thread, at least every 100
  /// ms. Throws Error{interrupted} within some 100 ms after a stop is requested through `stop`.
  /// Throws Error{exhausted} if there is not enough memory.
  Film render(const Scene& scene, const std::function<void(const Progress&)>& progress = {},
              std::stop_token stop = {});

  /// Returns the devices that share the work.
  std::vector<DeviceInfo> devices() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat
