#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "core/error.hpp"
#include "render/progressive.hpp"

namespace aerostat::viewer {

/// A look as the window shows it.
struct Shown {
  render::Look look;
  QImage image;
  std::uint64_t request = 0;  // whose it is
  QString device;
};

/// What hinders the picture.
struct Trouble {
  ErrorKind kind = ErrorKind::internal;
  QString message;
  std::uint64_t request = 0;
};

/// A device that can be chosen.
struct DeviceChoice {
  QString selector, name;
};

/// Renders on a thread of its own whatever scene was asked for last. Everything it has to say
/// arrives on the thread that made it, the newest look only, and nothing after its end.
class RenderThread {
 public:
  struct Listener {
    std::function<void(std::shared_ptr<const Shown>)> shown;
    std::function<void(render::Progress)> progressed;
    std::function<void(Trouble)> troubled;
    std::function<void(std::vector<DeviceChoice>)> devices_found;
  };

  /// Renders by `options`, on devices of its own choice.
  explicit RenderThread(Listener listener, render::Options options = {});
  /// Stops what is under way and waits for it.
  ~RenderThread();
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// Renders this scene (not resolved) in the place of any other. Returns its number.
  std::uint64_t render(const scene::Scene& scene);
  /// Gives up what is under way; the next `render` goes on.
  void pause();
  /// Renders on another device from now on; "" is the automatic one.
  void use_device(const QString& selector);

 private:
  struct Request {
    std::optional<scene::Scene> scene;
    std::uint64_t number = 0;
    bool other_device = false;
  };

  void run(const std::stop_token& end);
  template <typename Action>
  void guarded(std::uint64_t request, Action action);
  void serve(const Request& request, const std::stop_token& stop);
  void ask(Request request);
  void find_devices();
  void show(const render::Look& look, std::uint64_t request);
  void tell(std::function<void()> message);
  void deliver();

  QObject receiver_;
  Listener listener_;
  const render::Options options_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Request> next_;
  std::stop_source stop_;  // of what is under way
  std::uint64_t last_number_ = 0;
  QString selector_;
  std::shared_ptr<const Shown> newest_;  // not delivered yet

  std::unique_ptr<render::Progressive> progressive_;
  QString device_;
  std::jthread thread_;
};

}  // namespace aerostat::viewer
