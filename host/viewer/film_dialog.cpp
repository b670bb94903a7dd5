#include "viewer/film_dialog.hpp"

#include <QComboBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <exception>

#include "core/file.hpp"
#include "film/film_run.hpp"
#include "film/timeline.hpp"
#include "scene/scene.hpp"
#include "viewer/controls.hpp"
#include "viewer/film_job.hpp"
#include "viewer/screen_fit.hpp"

namespace aerostat::viewer {
namespace {

QString suggested_path(const Document& document) {
  const QFileInfo file(document.path());
  const bool is_unnamed = document.path().isEmpty();
  const QString name = is_unnamed ? QStringLiteral("aerostat") : file.completeBaseName();
  const QString folder = is_unnamed ? QDir::currentPath() : file.absolutePath();
  return folder + "/" + name + ".mp4";
}

}  // namespace

FilmDialog::FilmDialog(const Document& document, const QString& device, QWidget* parent)
    : QDialog(parent),
      document_(document),
      device_(device),
      path_(new QLineEdit(suggested_path(document))),
      quality_(new QComboBox),
      progress_(new QProgressBar),
      message_(new QLabel),
      browse_(new QPushButton(tr("&Browse…"))),
      export_(new QPushButton(tr("&Export"))),
      close_(new QPushButton(tr("Close"))) {
  setWindowTitle(tr("Export Film"));
  build();
}

FilmDialog::~FilmDialog() = default;

void FilmDialog::build() {
  quality_->addItem(tr("Preview (small, to look at the movement)"), QStringLiteral("preview"));
  for (const char* word : {"draft", "standard", "final"}) {
    quality_->addItem(word_text(QString::fromLatin1(word)), QString::fromLatin1(word));
  }
  quality_->addItem(tr("As the scene says"), QString());
  set_quality(QStringLiteral("standard"));
  browse_->setAutoDefault(false);
  connect(browse_, &QPushButton::clicked, this, &FilmDialog::choose_path);
  auto* file = new QHBoxLayout;
  file->addWidget(path_, 1);
  file->addWidget(browse_);
  const scene::Scene& scene = document_.scene();
  auto* form = new QFormLayout;
  form->addRow(tr("File"), file);
  form->addRow(tr("Quality"), quality_);
  form->addRow(tr("Film"), new QLabel(tr("%1 frames of %2 × %3 pixels, %4 s")
                                          .arg(film::frame_count(scene.film))
                                          .arg(scene.image.width)
                                          .arg(scene.image.height)
                                          .arg(scene.film.duration_s)));
  auto* hint = new QLabel(
      tr("Frames stay in a folder beside the film, so that a film that was cancelled goes on and "
         "only what changed is rendered again. Names end in .mp4, .mov, .mkv or .webm; a name such "
         "as frames/####.png makes frames alone."));
  hint->setWordWrap(true);
  progress_->setRange(0, 1000);
  QSizePolicy place = progress_->sizePolicy();
  place.setRetainSizeWhenHidden(true);
  progress_->setSizePolicy(place);
  progress_->setVisible(false);
  message_->setTextFormat(Qt::PlainText);
  message_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(export_);
  buttons->addWidget(close_);
  export_->setDefault(true);
  connect(export_, &QPushButton::clicked, this, &FilmDialog::begin);
  connect(close_, &QPushButton::clicked, this, &FilmDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(hint);
  layout->addWidget(progress_);
  layout->addWidget(message_);
  layout->addStretch(1);
  layout->addLayout(buttons);
  resize_to_fit(*this, QSize(560, sizeHint().height()));
}

void FilmDialog::set_path(const QString& path) {
  path_->setText(path);
  agreed_path_ = path;
}

void FilmDialog::set_quality(const QString& quality) {
  quality_->setCurrentIndex(quality_->findData(quality));
}

QString FilmDialog::message() const {
  return message_->text();
}

void FilmDialog::choose_path() {
  const QString path = QFileDialog::getSaveFileName(this, tr("Export Film"), path_->text(),
                                                    tr("Films (*.mp4 *.mov *.mkv *.webm)"));
  // The file dialog has already asked whether to replace the file.
  if (!path.isEmpty()) set_path(path);
}

/// Returns whether a film may be written. The scene file itself may not, and an older film only
/// after a question. Frames are replaced only if they belong to another film.
bool FilmDialog::may_write(const QString& path) {
  if (is_same_file(path.toStdString(), document_.path().toStdString())) {
    message_->setText(tr("This is the scene file itself; give the film another name."));
    return false;
  }
  if (path == agreed_path_ || !QFileInfo(path).isFile()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Export Film"),
                            tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName()));
  if (answer != QMessageBox::Yes) return false;
  agreed_path_ = path;
  return true;
}

/// Returns the scene in the quality of the dialog.
scene::SceneSource FilmDialog::source() const {
  const QString quality = quality_->currentData().toString();
  if (quality.isEmpty()) return document_.source();
  if (quality == QLatin1String("preview")) return film::preview_of(document_.source());
  return document_.source()
      .without({"/image/spp", "/sun/soft_shadows", "/sky/ambient_occlusion"})
      .with({{"/quality", quality.toStdString()}});
}

void FilmDialog::begin() {
  if (job_) return;
  QString path = path_->text().trimmed();
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".mp4");
  if (!may_write(path)) return;
  try {
    const scene::SceneSource made = source();
    message_->clear();
    job_ = std::make_unique<FilmJob>();
    connect(
        job_.get(), &FilmJob::progressed, this,
        [this](double fraction, const QString& text) {
          progress_->setValue(static_cast<int>(fraction * 1000.0));
          progress_->setFormat(text + QStringLiteral(" (%p %)"));
        },
        Qt::QueuedConnection);
    connect(job_.get(), &FilmJob::finished, this, &FilmDialog::end, Qt::QueuedConnection);
    set_busy(true);
    job_->start(made, path, device_);
  } catch (const std::exception& error) {
    job_.reset();
    set_busy(false);
    message_->setText(QString::fromUtf8(error.what()));
  }
}

void FilmDialog::end(bool written, const QString& message) {
  if (!job_) return;
  job_.reset();
  set_busy(false);
  message_->setText(message.isEmpty() ? tr("Cancelled; the frames that are made are kept.")
                                      : message);
  Q_EMIT ended(written);
}

void FilmDialog::set_busy(bool busy) {
  // The focus would otherwise move to an arbitrary widget after the disabled one.
  if (busy) close_->setFocus();
  for (QWidget* widget : {static_cast<QWidget*>(path_), static_cast<QWidget*>(quality_),
                          static_cast<QWidget*>(browse_), static_cast<QWidget*>(export_)}) {
    widget->setEnabled(!busy);
  }
  progress_->setVisible(busy);
  progress_->setValue(0);
  close_->setText(busy ? tr("Cancel") : tr("Close"));
}

void FilmDialog::reject() {
  if (job_) {
    job_->cancel();
    message_->setText(tr("Cancelling…"));
    return;
  }
  QDialog::reject();
}

}  // namespace aerostat::viewer
