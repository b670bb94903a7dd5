#include <QLabel>
#include <QStatusBar>
#include <cmath>

#include "render/kernel_progress.hpp"
#include "scene/scene.hpp"
#include "viewer/main_window.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/timeline_panel.hpp"

namespace aerostat::viewer {
namespace {

QString stage_text(const render::Progress& progress) {
  switch (progress.stage) {
    case render::Stage::world:
      return MainWindow::tr("building the land…");
    case render::Stage::tree:
      return MainWindow::tr("building trees…");
    case render::Stage::kernels:
      if (progress.seconds < render::kLeastCompileSeconds)
        return MainWindow::tr("compiling kernels…");
      return MainWindow::tr("compiling kernels (first run only), %1 %…")
          .arg(std::floor(100.0 * progress.fraction));
    case render::Stage::upload:
      return MainWindow::tr("uploading…");
    default:
      return {};
  }
}

/// Returns whether a playing film goes on after this look: it shows the fine land with large pixels
/// at most, or it took so long that better ones would take too long.
bool is_enough_to_play(const render::Preview& preview) {
  // Chosen by eye.
  constexpr int kMostShrink = 4;
  constexpr double kPatience_s = 0.4;
  return preview.complete || preview.seconds > kPatience_s ||
         (!preview.rough && preview.shrink <= kMostShrink);
}

double rays_per_second(const render::Stats& stats) {
  const auto rays = stats.rays.sum();
  return stats.rays_seconds > 0.0 ? static_cast<double>(rays) / stats.rays_seconds : 0.0;
}

}  // namespace

void MainWindow::build_status() {
  device_label_ = new QLabel;
  work_label_ = new QLabel;
  place_label_ = new QLabel;
  for (QLabel* label : {place_label_, device_label_}) label->setContentsMargins(8, 0, 8, 0);
  // A long text is cut off, so that it does not widen the window beyond the screen.
  for (QLabel* label : {work_label_, place_label_, device_label_}) label->setMinimumWidth(1);
  statusBar()->addWidget(work_label_, 1);
  statusBar()->addPermanentWidget(place_label_);
  statusBar()->addPermanentWidget(device_label_);
}

void MainWindow::show_look(std::shared_ptr<const Shown> shown) {
  const render::Preview& preview = shown->preview;
  shown_ = shown;
  camera_.note(shown);
  models_.note(shown);
  view_->show_image(shown->image, QSize(preview.scene->image.width, preview.scene->image.height));
  QStringList parts;
  parts << tr("%1 × %2").arg(preview.scene->image.width).arg(preview.scene->image.height);
  if (preview.shrink > 1) {
    parts << tr("1/%1 of the size").arg(preview.shrink);
  } else {
    parts << tr("%n sample(s) a pixel", nullptr, preview.samples);
  }
  if (preview.rough) parts << tr("coarse land");
  const double rate = rays_per_second(preview.stats);
  if (rate > 0.0) parts << tr("%1 Mrays/s").arg(rate * 1e-6, 0, 'f', 1);
  parts << tr("%1 s").arg(preview.seconds, 0, 'f', 2);
  if (preview.complete) parts << tr("done");
  work_label_->setText(parts.join(QStringLiteral("  ·  ")));
  device_label_->setText(shown->device);
  device_label_->setToolTip(shown->device);
  if (const auto height = camera_.height_above_ground()) {
    place_label_->setText(tr("eye %1 m above ground").arg(*height, 0, 'f', 0));
  }
  panels_->show_view();
  if (shown->request == request_ && is_enough_to_play(preview)) timeline_->frame_arrived();
  show_mark();
  Q_EMIT look_arrived();
}

void MainWindow::show_progress(const render::Progress& progress) {
  const QString text = stage_text(progress);
  if (!text.isEmpty() && progress.seconds > 0.2) {
    work_label_->setText(tr("%1  ·  %2 s").arg(text).arg(progress.seconds, 0, 'f', 1));
  }
}

}  // namespace aerostat::viewer
