#include "viewer/render_thread.hpp"

#include <QCoreApplication>
#include <QMetaObject>

#include "film/timeline.hpp"
#include "image/write.hpp"
#include "opencl/device.hpp"
#include "render/scene_cache.hpp"
#include "render/self_test.hpp"
#include "scene/scene.hpp"
#include "viewer/picture.hpp"

namespace aerostat::viewer {

RenderThread::RenderThread(Listener listener, render::TestHooks hooks)
    : listener_(std::move(listener)),
      watch_([this](int seconds) { tell_of_silence(seconds); }, [this] { listener_.answered(); }),
      hooks_(std::move(hooks)),
      thread_([this](const std::stop_token& end) { run(end); }) {}

RenderThread::Handle RenderThread::start(Listener listener, render::TestHooks hooks) {
  return Handle(new RenderThread(std::move(listener), std::move(hooks)));
}

void RenderThread::Ender::operator()(RenderThread* thread) const {
  thread->stop();
  if (ends_soon(thread->ended_, thread->watch_)) {
    delete thread;
    return;
  }
  thread->is_left_behind_ = true;
  thread->watch_.stop();
  leave_behind(thread);
}

void RenderThread::stop() {
  thread_.request_stop();
  const std::lock_guard lock(mutex_);
  stop_.request_stop();
}

void RenderThread::tell_of_silence(int seconds) {
  listener_.troubled({ErrorKind::exhausted,
                      QCoreApplication::translate("RenderThread",
                                                  "The device has not answered for %1 s. It may be "
                                                  "lost, or busy with other work.")
                          .arg(seconds),
                      0, true});
}

std::uint64_t RenderThread::render(const scene::Scene& scene) {
  ask({std::make_shared<const scene::Scene>(scene), 0, false, nullptr, 0.0});
  return last_number_;
}

std::uint64_t RenderThread::render(const scene::SceneSource& source, double time_s) {
  ask({std::make_shared<const scene::Scene>(source.scene()), 0, false,
       std::make_shared<const scene::SceneSource>(source), time_s});
  return last_number_;
}

void RenderThread::pause() {
  const std::lock_guard lock(mutex_);
  next_.reset();
  stop_.request_stop();
}

void RenderThread::use_device(const QString& selector) {
  {
    const std::lock_guard lock(mutex_);
    selector_ = selector;
  }
  ask({nullptr, 0, true, nullptr, 0.0});
}

/// Keeps the newest request. A change of the device is kept until it is served.
void RenderThread::ask(Request request) {
  const std::lock_guard lock(mutex_);
  request.number = ++last_number_;
  if (next_) {
    request.other_device = request.other_device || next_->other_device;
    if (!request.scene) {
      request.scene = next_->scene;
      request.film = next_->film;
      request.time_s = next_->time_s;
    }
  }
  next_ = std::move(request);
  stop_.request_stop();
  wake_.notify_all();
}

void RenderThread::run(const std::stop_token& end) {
  work(end);
  // What a driver holds is given back on this thread, which may be left behind.
  progressive_.reset();
  end_.set_value();
}

void RenderThread::work(const std::stop_token& end) {
  guarded(0, [this] { find_devices(); });
  while (!end.stop_requested()) {
    Request request;
    std::stop_token stop;
    {
      std::unique_lock lock(mutex_);
      if (!wake_.wait(lock, end, [this] { return next_.has_value(); })) return;
      request = *std::move(next_);
      next_.reset();
      stop_ = {};
      stop = stop_.get_token();
      if (end.stop_requested()) return;
    }
    guarded(request.number, [&] { serve(request, stop); });
  }
}

/// Runs `action` and reports its errors. A device that failed is released, because it may be lost.
template <typename Action>
void RenderThread::guarded(std::uint64_t request, Action action) {
  Trouble trouble{ErrorKind::internal, {}, request, false};
  const DeviceWatch::Busy busy(watch_);
  try {
    action();
    return;
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::interrupted) return;
    trouble.kind = error.kind();
    trouble.message = QString::fromUtf8(error.what());
  } catch (const std::bad_alloc&) {
    trouble.kind = ErrorKind::exhausted;
    trouble.message = QStringLiteral("out of memory");
  } catch (const std::exception& error) {
    trouble.message = QString::fromUtf8(error.what());
  }
  if (trouble.kind != ErrorKind::bad_data) {
    progressive_.reset();
    film_.reset();
    cache_.reset();
  }
  tell([this, trouble] { listener_.troubled(trouble); });
}

void RenderThread::make_renderer(const Request& request) {
  QString selector;
  {
    const std::lock_guard lock(mutex_);
    selector = selector_;
  }
  render::Options options;
  // The test is not stopped by edits, because it would have to compile its kernels again.
  render::SelfTest test;
  test.integrator = request.scene->light;
  test.progress = [this](const render::Progress& progress) {
    watch_.sign(progress);
    if (progress.stage != render::Stage::kernels) return;
    tell([this, progress] { listener_.progressed(progress); });
  };
  options.devices = render::select_tested(opencl::effective_selector(selector.toStdString()), test);
  device_.clear();
  for (const auto& device : options.devices) {
    device_ += (device_.isEmpty() ? "" : " + ") + QString::fromStdString(device.name);
  }
  options.cache = cache_;
  progressive_ = std::make_unique<render::Progressive>(std::move(options), hooks_);
}

/// Returns the scene to render. A film is kept until another scene or another film is asked for.
scene::Scene RenderThread::scene_of(const Request& request) {
  if (!request.film) return *request.scene;
  if (!film_ || film_text_ != request.film->text()) {
    film_.reset();
    film_ = std::make_unique<film::Timeline>(*request.film, cache_->reliefs);
    film_text_ = request.film->text();
  }
  return film_->scene_at_time(request.time_s);
}

void RenderThread::serve(const Request& request, const std::stop_token& stop) {
  if (request.other_device) progressive_.reset();
  if (!request.scene) return;
  if (!cache_) cache_ = std::make_shared<render::SceneCache>();
  if (!progressive_) make_renderer(request);
  double told = -1.0;
  progressive_->render(
      scene_of(request), stop,
      [&](const render::Preview& preview) { show(preview, request.number); },
      [&](const render::Progress& progress) {
        watch_.sign(progress);
        if (progress.seconds - told < 0.1 && progress.seconds >= told) return;
        told = progress.seconds;
        tell([this, progress] { listener_.progressed(progress); });
      });
}

void RenderThread::find_devices() {
  const auto list = opencl::list_devices();
  std::vector<DeviceChoice> choices;
  for (const opencl::Device& device : list.devices) {
    choices.push_back({QString::fromStdString(device.selector()),
                       QString::fromStdString(device.name + " (" + device.platform + ")")});
  }
  tell([this, choices] { listener_.devices_found(choices); });
}

void RenderThread::show(const render::Preview& preview, std::uint64_t request) {
  auto shown = std::make_shared<Shown>(Shown{preview, picture_of(preview), request, device_});
  const std::lock_guard lock(mutex_);
  const bool waits = newest_ != nullptr;
  newest_ = std::move(shown);
  if (!waits) tell([this] { deliver(); });
}

void RenderThread::deliver() {
  std::shared_ptr<const Shown> shown;
  {
    const std::lock_guard lock(mutex_);
    shown.swap(newest_);
  }
  if (shown) listener_.shown(std::move(shown));
}

void RenderThread::tell(std::function<void()> message) {
  const auto unless_left_behind = [this, message = std::move(message)] {
    if (!is_left_behind_) message();
  };
  QMetaObject::invokeMethod(&receiver_, unless_left_behind, Qt::QueuedConnection);
}

}  // namespace aerostat::viewer
