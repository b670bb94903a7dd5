#include "viewer/film_dialog.hpp"

#include <QLabel>
#include <utility>

#include "film/film_run.hpp"
#include "film/timeline.hpp"
#include "scene/scene.hpp"
#include "viewer/film_job.hpp"

namespace aerostat::viewer {
namespace {

constexpr const char* kPreview = "preview";

}  // namespace

FilmDialog::FilmDialog(const Document& document, const QString& device, QWidget* parent)
    : OutputDialog(
          document, device,
          {tr("Export Film"), QStringLiteral("mp4"), tr("Films (*.mp4 *.mov *.mkv *.webm)"),
           tr("This is the scene file itself; give the film another name."),
           tr("Cancelled; the frames that are made are kept."),
           tr("The device has not answered for %1 s. Cancel gives the film up."),
           tr("The device did not answer, and the film was given up; the frames that are made are "
              "kept.")},
          parent) {
  add_quality(tr("Preview (small, to look at the movement)"), QString::fromLatin1(kPreview));
  add_scene_qualities();
  set_quality(QStringLiteral("standard"));
  const scene::Scene& scene = document.scene();
  add_row(tr("Film"), new QLabel(tr("%1 frames of %2 × %3 pixels, %4 s")
                                     .arg(film::frame_count(scene.film))
                                     .arg(scene.image.width)
                                     .arg(scene.image.height)
                                     .arg(scene.film.duration_s)));
  lay_out(tr("Frames stay in a folder beside the film, so that a film that was cancelled goes on "
             "and only what changed is rendered again. Names end in .mp4, .mov, .mkv or .webm; a "
             "name such as frames/####.png makes frames alone."),
          560);
}

void FilmDialog::start(const QString& path) {
  const scene::SceneSource& given = document().source();
  const bool is_preview = quality() == QLatin1String(kPreview);
  const scene::SceneSource made = is_preview ? film::preview_of(given) : in_quality(given);
  auto job = FilmJob::make();
  FilmJob& started = *job;
  follow(std::move(job));
  started.start(made, path, device());
}

}  // namespace aerostat::viewer
