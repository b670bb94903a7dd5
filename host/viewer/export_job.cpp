#include "viewer/export_job.hpp"

#include <QDir>
#include <QFileInfo>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "core/stop_scope.hpp"
#include "image/write.hpp"
#include "opencl/device.hpp"
#include "render/development.hpp"
#include "render/scene_cache.hpp"
#include "render/self_test.hpp"
#include "render/session.hpp"
#include "scene/scene.hpp"
#include "world/resolve.hpp"

namespace aerostat::viewer {
namespace {

/// Returns the share of the whole work that is done when a stage begins. The shares are rough and
/// chosen by eye.
double begin_of(render::Stage stage) {
  switch (stage) {
    case render::Stage::world:
    case render::Stage::tree:
      return 0.0;
    case render::Stage::kernels:
    case render::Stage::upload:
      return 0.04;
    default:
      return 0.05;
  }
}

QString text_of(render::Stage stage) {
  switch (stage) {
    case render::Stage::kernels:
      return ExportJob::tr("Compiling kernels…");
    case render::Stage::rays:
    case render::Stage::done:
      return ExportJob::tr("Tracing rays…");
    default:
      return ExportJob::tr("Building the world…");
  }
}

}  // namespace

void ExportJob::start(const scene::Scene& scene, const QString& path, const QString& device) {
  before_ = file_stamp(path.toStdString());
  begin(
      [this, scene, path, device](const std::stop_token& stop) { run(stop, scene, path, device); });
}

void ExportJob::tell(const render::Progress& progress) {
  watch().sign(progress);
  const double begin = begin_of(progress.stage);
  const bool traces = progress.stage == render::Stage::rays;
  Q_EMIT progressed(traces ? begin + (1.0 - begin) * progress.fraction : begin,
                    text_of(progress.stage));
}

void ExportJob::run(const std::stop_token& stop, const scene::Scene& scene, const QString& path,
                    const QString& device) {
  const std::filesystem::path file = path.toStdString();
  require_writable(file);
  render::Options options;
  render::SelfTest test;
  test.integrator = scene.light;
  test.stop = stop;
  test.progress = [this](const render::Progress& progress) { watch().sign(progress); };
  // Signs are expected of the device alone. Reading a land or encoding a picture may take long.
  std::optional<DeviceWatch::Busy> busy(watch());
  options.devices = render::select_tested(opencl::effective_selector(device.toStdString()), test);
  const bool is_exr =
      QFileInfo(path).suffix().compare(QLatin1String("exr"), Qt::CaseInsensitive) == 0;
  options.contents = is_exr ? render::Contents::layers : render::Contents::picture;
  options.guides = is_exr;
  const auto cache = std::make_shared<render::SceneCache>();
  options.cache = cache;
  render::Session session(std::move(options));
  session.begin_kernels(scene.light);
  busy.reset();
  const scene::ResolvedScene resolved = world::resolve(scene, cache->reliefs);
  busy.emplace(watch());
  const auto film =
      session.render(resolved, stop, [this](const render::Progress& progress) { tell(progress); });
  busy.reset();
  const std::vector<std::uint8_t> bytes =
      is_exr ? image::encode_exr(film)
             : image::encode_png(image::develop(film, render::development_of(scene.image, film)));
  stop_if_asked(stop);
  if (!is_special_file(file) && file_stamp(file) != before_) {
    Q_EMIT obstructed(QByteArray(reinterpret_cast<const char*>(bytes.data()),
                                 static_cast<qsizetype>(bytes.size())));
    return;
  }
  write_file(file, bytes);
  Q_EMIT finished(true, tr("Wrote %1").arg(QDir::toNativeSeparators(path)));
}

}  // namespace aerostat::viewer
