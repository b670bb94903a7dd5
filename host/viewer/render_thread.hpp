#pragma once

#include <QImage>
#include <QObject>
#include <QString>
#include <QStringList>
#include <condition_variable>
#include <functional>
#include <future>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>

#include "core/error.hpp"
#include "render/progressive.hpp"
#include "render/test_hooks.hpp"
#include "scene/source.hpp"
#include "viewer/device_watch.hpp"

namespace aerostat::film {
class Timeline;
}

namespace aerostat::render {
struct SceneCache;
}

namespace aerostat::viewer {

/// A preview as the window shows it.
struct Shown {
  render::Preview preview;
  QImage image;
  /// The number of the request that the preview belongs to.
  std::uint64_t request = 0;
  QString device;
};

/// An error that prevents the picture.
struct Trouble {
  ErrorKind kind = ErrorKind::internal;
  QString message;
  std::uint64_t request = 0;
  /// Tells whether the device does not answer. Then this thread cannot go on, unless the device
  /// answers after all, and is to be replaced.
  bool hangs = false;
};

/// A device that can be chosen.
struct DeviceChoice {
  QString selector, name;
};

/// Renders the scene that was requested last, on a thread of its own. All reports arrive on the
/// thread that made this object. Only the newest preview is reported, and nothing is reported after
/// the end of this object.
class RenderThread {
 public:
  struct Listener {
    std::function<void(std::shared_ptr<const Shown>)> shown;
    std::function<void(render::Progress)> progressed;
    std::function<void(Trouble)> troubled;
    std::function<void(std::vector<DeviceChoice>)> devices_found;
    /// The device that was told to hang answers.
    std::function<void()> answered;
  };

  /// Stops the present render and waits for its end. If the device hangs, the thread is left behind
  /// and nothing is reported any more.
  struct Ender {
    void operator()(RenderThread* thread) const;
  };
  using Handle = std::unique_ptr<RenderThread, Ender>;

  /// Starts a thread. Only tests give hooks.
  static Handle start(Listener listener, render::TestHooks hooks = {});
  RenderThread(const RenderThread&) = delete;
  RenderThread& operator=(const RenderThread&) = delete;

  /// Renders this scene instead of any other. The scene is not resolved. Returns the number of the
  /// request.
  std::uint64_t render(const scene::Scene& scene);
  /// Renders the film of a scene at a time in seconds.
  std::uint64_t render(const scene::SceneSource& source, double time_s);
  /// Gives up the present render. The next `render` goes on.
  void pause();
  /// Renders on another device from now on. The empty selector is the automatic one.
  void use_device(const QString& selector);

 private:
  struct Request {
    /// The scene to render, or null for the same again.
    std::shared_ptr<const scene::Scene> scene;
    std::uint64_t number = 0;
    bool other_device = false;
    /// The film whose scene at a time is rendered in place of `scene`, or null.
    std::shared_ptr<const scene::SceneSource> film;
    double time_s = 0.0;
  };

  RenderThread(Listener listener, render::TestHooks hooks);
  ~RenderThread() = default;
  void stop();
  void run(const std::stop_token& end);
  void work(const std::stop_token& end);
  void tell_of_silence(int seconds);
  template <typename Action>
  void guarded(std::uint64_t request, Action action);
  void serve(const Request& request, const std::stop_token& stop);
  scene::Scene scene_of(const Request& request);
  void make_renderer(const Request& request);
  void ask(Request request);
  void find_devices();
  void show(const render::Preview& preview, std::uint64_t request);
  void tell(std::function<void()> message);
  void deliver();

  QObject receiver_;
  Listener listener_;
  /// Tells that nobody listens any more.
  bool is_left_behind_ = false;
  DeviceWatch watch_;
  const render::TestHooks hooks_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::optional<Request> next_;
  /// Stops the present render.
  std::stop_source stop_;
  std::uint64_t last_number_ = 0;
  QString selector_;
  /// The newest preview, which is not delivered yet.
  std::shared_ptr<const Shown> newest_;

  /// What scenes need beside their geometry, for the renderer and the film.
  std::shared_ptr<render::SceneCache> cache_;
  std::unique_ptr<render::Progressive> progressive_;
  /// The film that was asked for last, and the text of its scene.
  std::unique_ptr<film::Timeline> film_;
  std::string film_text_;
  QString device_;
  std::promise<void> end_;
  std::future<void> ended_ = end_.get_future();
  std::jthread thread_;
};

}  // namespace aerostat::viewer
