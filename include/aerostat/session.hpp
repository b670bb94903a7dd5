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
  /// Which devices render: "auto" (a GPU if there is one, else the CPU), "cpu", "gpu", "0:1", a
  /// part of a name, "all", or several with commas between them. Empty: what the environment
  /// variable AEROSTAT_DEVICE says, or else "auto".
  std::string device;
  int lanes = 0;  ///< rays of a work-item: 1, 4, 8 or 16; 0: what fits the device
  std::uint64_t memory_limit_bytes = 0;  ///< for buffers on each device; 0: what the device reports
  /// For views that move: plants out of sight are placed, too, so that a camera that turns costs
  /// nothing. False: for single pictures, each of them as quick as it can be.
  bool interactive = false;
};

enum class Stage { world, trees, kernels, upload, rays, done };

struct Progress {
  Stage stage = Stage::world;
  double fraction = 0.0;  ///< of the stage, 0 to 1
  double seconds = 0.0;   ///< since the render began
};

/// Renders scenes one after the other, and keeps what the next one can use: meshes, trees, kernels
/// and buffers. A scene that differs by its camera alone builds nothing. Use a session from one
/// thread at a time; several sessions can be used side by side.
class AEROSTAT_API Session {
 public:
  /// Throws Error{no_device} if no device fits, Error{usage} if the options make no sense.
  explicit Session(const SessionOptions& options = {});
  ~Session();
  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;

  /// Renders all samples of the scene. `progress` is called from this thread, at least every 100
  /// ms. If `stop` is requested, throws Error{interrupted} within some 100 ms. Throws
  /// Error{exhausted} if memory does not suffice.
  Film render(const Scene& scene, const std::function<void(const Progress&)>& progress = {},
              std::stop_token stop = {});

  /// The devices that share the work.
  std::vector<DeviceInfo> devices() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace aerostat
