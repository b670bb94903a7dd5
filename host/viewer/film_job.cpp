#include "viewer/film_job.hpp"

#include <memory>
#include <vector>

#include "core/file.hpp"
#include "film/film_run.hpp"
#include "film/frames.hpp"
#include "film/timeline.hpp"
#include "opencl/device.hpp"
#include "render/scene_cache.hpp"
#include "render/self_test.hpp"
#include "scene/scene.hpp"

namespace aerostat::viewer {
namespace {

QString text_of(const film::FilmProgress& now) {
  if (now.number == 0) return FilmJob::tr("Encoding…");
  if (now.render.stage == render::Stage::kernels) return FilmJob::tr("Compiling kernels…");
  const QString text =
      FilmJob::tr("Frame %1, %2 of %3").arg(now.number).arg(now.made + 1).arg(now.to_make);
  if (!(now.frames_per_s > 0.0)) return text;
  return FilmJob::tr("%1, %2 frames/s").arg(text).arg(now.frames_per_s, 0, 'f', 2);
}

}  // namespace

void FilmJob::start(const scene::SceneSource& source, const QString& path, const QString& device) {
  begin([this, source, path, device](const std::stop_token& stop) {
    run(stop, source, path, device);
  });
}

void FilmJob::tell(const film::FilmProgress& now) {
  const render::Stage stage = now.render.stage;
  const bool is_of_device =
      now.number != 0 && (stage == render::Stage::kernels || stage == render::Stage::upload ||
                          stage == render::Stage::rays);
  if (!is_of_device) {
    busy_.reset();
  } else if (!busy_) {
    busy_.emplace(watch());
  }
  watch().sign(now.render);
  Q_EMIT progressed(now.fraction(), text_of(now));
}

void FilmJob::run(const std::stop_token& stop, const scene::SceneSource& source,
                  const QString& path, const QString& device) {
  const scene::Scene& scene = source.scene();
  film::FilmTask task{film::film_files(path.toStdString()), {}, 0.0, true};
  task.encoder = {task.files.video, {}, scene.image.width, scene.image.height, scene.film.fps};
  if (!task.files.video.empty()) {
    film::require_encodable(task.encoder);
    require_writable(task.files.video);
  }
  render::Options options;
  render::SelfTest test;
  test.integrator = scene.light;
  test.stop = stop;
  test.progress = [this](const render::Progress& progress) { watch().sign(progress); };
  busy_.emplace(watch());
  options.devices = render::select_tested(opencl::effective_selector(device.toStdString()), test);
  busy_.reset();
  options.cache = std::make_shared<render::SceneCache>();
  film::Timeline timeline(source, options.cache->reliefs);
  const std::vector<int> numbers = film::frames_of({}, {}, timeline.frames());
  const auto frames = film::survey(timeline, task.files, numbers, stop);
  const film::FilmOutcome outcome = film::make_film(
      timeline, options, task, frames, stop, [this](const film::FilmProgress& now) { tell(now); });
  if (outcome.no_encoder) {
    Q_EMIT finished(false, QString::fromUtf8(outcome.no_encoder->what()));
    return;
  }
  const auto all = static_cast<int>(frames.size());
  Q_EMIT finished(true, tr("Wrote %1: %2 frames rendered, %3 kept")
                            .arg(path)
                            .arg(outcome.made)
                            .arg(all - outcome.made));
}

}  // namespace aerostat::viewer
