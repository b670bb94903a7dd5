#include "viewer/export_dialog.hpp"

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

#include "scene/scene.hpp"
#include "viewer/controls.hpp"
#include "viewer/screen_fit.hpp"

namespace aerostat::viewer {
namespace {

QString suggested_path(const Document& document) {
  const QFileInfo file(document.path());
  const QString name =
      document.path().isEmpty() ? QStringLiteral("aerostat") : file.completeBaseName();
  const QString folder = document.path().isEmpty() ? QDir::currentPath() : file.absolutePath();
  return folder + "/" + name + ".png";
}

WholeBox* pixels_box(int value) {
  auto* box = new WholeBox;
  box->setRange(1, 32768);
  box->setSuffix(ExportDialog::tr(" px"));
  box->setValue(value);
  return box;
}

}  // namespace

ExportDialog::ExportDialog(const Document& document, const QString& device, QWidget* parent)
    : QDialog(parent),
      document_(document),
      device_(device),
      path_(new QLineEdit(suggested_path(document))),
      quality_(new QComboBox),
      width_(pixels_box(document.scene().image.width)),
      height_(pixels_box(document.scene().image.height)),
      progress_(new QProgressBar),
      message_(new QLabel),
      browse_(new QPushButton(tr("&Browse…"))),
      export_(new QPushButton(tr("&Export"))),
      close_(new QPushButton(tr("Close"))) {
  setWindowTitle(tr("Export Picture"));
  build();
}

ExportDialog::~ExportDialog() = default;

void ExportDialog::build() {
  for (const char* word : {"draft", "standard", "final"}) {
    quality_->addItem(word_text(QString::fromLatin1(word)), QString::fromLatin1(word));
  }
  quality_->addItem(tr("As the scene says"), QString());
  quality_->setCurrentIndex(2);
  browse_->setAutoDefault(false);
  connect(browse_, &QPushButton::clicked, this, &ExportDialog::choose_path);
  auto* file = new QHBoxLayout;
  file->addWidget(path_, 1);
  file->addWidget(browse_);
  auto* size = new QHBoxLayout;
  size->addWidget(width_);
  size->addWidget(new QLabel(QStringLiteral("×")));
  size->addWidget(height_);
  size->addStretch(1);
  auto* form = new QFormLayout;
  form->addRow(tr("File"), file);
  form->addRow(tr("Quality"), quality_);
  form->addRow(tr("Size"), size);
  auto* hint =
      new QLabel(tr("A name that ends in .exr keeps the light as it is, with distances, "
                    "normals and objects in layers; any other gives a PNG."));
  hint->setWordWrap(true);
  progress_->setRange(0, 1000);
  QSizePolicy place = progress_->sizePolicy();
  // The bar keeps its place while it is hidden, so that the rows above are not squeezed.
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
  connect(export_, &QPushButton::clicked, this, &ExportDialog::begin);
  connect(close_, &QPushButton::clicked, this, &ExportDialog::reject);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(form);
  layout->addWidget(hint);
  layout->addWidget(progress_);
  layout->addWidget(message_);
  layout->addStretch(1);
  layout->addLayout(buttons);
  resize_to_fit(*this, QSize(520, sizeHint().height()));
}

void ExportDialog::set_path(const QString& path) {
  path_->setText(path);
  agreed_path_ = path;
}

void ExportDialog::set_quality(const QString& quality) {
  quality_->setCurrentIndex(quality_->findData(quality));
}

QString ExportDialog::message() const {
  return message_->text();
}

void ExportDialog::choose_path() {
  const QString path =
      QFileDialog::getSaveFileName(this, tr("Export Picture"), path_->text(),
                                   tr("Pictures (*.png)") + ";;" + tr("OpenEXR (*.exr)"));
  // The file dialog has already asked whether to replace the file.
  if (!path.isEmpty()) set_path(path);
}

/// Returns the changes that give the scene the size of the dialog. Samples and light come from the
/// quality, whatever the scene says about them.
std::vector<scene::Override> ExportDialog::changes() const {
  return {{"/image/width", std::to_string(width_->value())},
          {"/image/height", std::to_string(height_->value())}};
}

void ExportDialog::begin() {
  for (WholeBox* box : {width_, height_}) {
    if (!box->is_readable()) {
      message_->setText(tr("Size: %1").arg(box->expected()));
      return;
    }
    // The shortcut Alt+E does not move the focus, so the text of a box may still have to be read.
    box->interpretText();
  }
  QString path = path_->text().trimmed();
  if (path.isEmpty()) return;
  const QFileInfo file(path);
  // A path such as "folder/" gets no suffix, so it is refused.
  if (file.suffix().isEmpty() && !file.fileName().isEmpty()) path += QStringLiteral(".png");
  if (!may_write(path)) return;
  scene::Scene scene;
  try {
    scene::SceneSource source = document_.source().with(changes());
    const QString quality = quality_->currentData().toString();
    if (!quality.isEmpty()) {
      source = source.without({"/image/spp", "/sun/soft_shadows", "/sky/ambient_occlusion"})
                   .with({{"/quality", quality.toStdString()}});
    }
    scene = source.scene();
  } catch (const std::exception& error) {
    message_->setText(QString::fromUtf8(error.what()));
    return;
  }
  message_->clear();
  job_ = ExportJob::make();
  connect(job_.get(), &ExportJob::progressed, this, &ExportDialog::show_progress,
          Qt::QueuedConnection);
  connect(
      job_.get(), &ExportJob::finished, this,
      [this, path](bool written, const QString& error) {
        end(written, written ? tr("Wrote %1").arg(QDir::toNativeSeparators(path)) : error);
      },
      Qt::QueuedConnection);
  connect(
      job_.get(), &ExportJob::obstructed, this, [this, path] { ask_about_file(path); },
      Qt::QueuedConnection);
  connect(job_.get(), &ExportJob::fell_silent, this, &ExportDialog::show_silence,
          Qt::QueuedConnection);
  set_busy(true);
  job_->start(scene, path, device_);
}

/// Returns whether a file may be written. The scene file itself may not, and an older file only
/// after a question.
bool ExportDialog::may_write(const QString& path) {
  if (is_same_file(path.toStdString(), document_.path().toStdString())) {
    message_->setText(tr("This is the scene file itself; give the picture another name."));
    return false;
  }
  if (path == agreed_path_ || !QFileInfo(path).isFile()) return true;
  const auto answer =
      QMessageBox::question(this, tr("Export Picture"),
                            tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName()));
  if (answer != QMessageBox::Yes) return false;
  agreed_path_ = path;
  return true;
}

/// Asks what to do with a finished picture if another program wrote its file while the picture was
/// rendered.
void ExportDialog::ask_about_file(QString path) {
  if (!job_) return;
  QMessageBox box(QMessageBox::Warning, tr("File Changed"),
                  tr("Another program wrote %1 while the picture was rendered.")
                      .arg(QFileInfo(path).fileName()),
                  QMessageBox::Discard, this);
  auto* overwrite = box.addButton(tr("Overwrite"), QMessageBox::DestructiveRole);
  auto* another = box.addButton(tr("Save As…"), QMessageBox::AcceptRole);
  box.exec();
  if (box.clickedButton() == another) {
    const QString suffix = QFileInfo(path).suffix();
    path = QFileDialog::getSaveFileName(this, tr("Export Picture"), path, "*." + suffix);
  } else if (box.clickedButton() != overwrite) {
    path.clear();
  }
  if (path.isEmpty()) return end(false, tr("The picture was discarded."));
  try {
    write_file(path.toStdString(), job_->bytes());
    end(true, tr("Wrote %1").arg(QDir::toNativeSeparators(path)));
  } catch (const std::exception& error) {
    end(false, QString::fromUtf8(error.what()));
  }
}

void ExportDialog::show_progress(double fraction, const QString& stage) {
  progress_->setValue(static_cast<int>(fraction * 1000.0));
  progress_->setFormat(stage + QStringLiteral(" %p %"));
}

void ExportDialog::show_silence(int seconds) {
  message_->setText(
      tr("The device has not answered for %1 s. Cancel gives the picture up.").arg(seconds));
}

void ExportDialog::end(bool written, const QString& error) {
  if (!job_) return;
  job_.reset();
  set_busy(false);
  message_->setText(error.isEmpty() ? tr("Cancelled") : error);
  Q_EMIT ended(written);
}

void ExportDialog::set_busy(bool busy) {
  // The focus would otherwise move to an arbitrary widget after the disabled one.
  if (busy) close_->setFocus();
  for (QWidget* widget : {static_cast<QWidget*>(path_), static_cast<QWidget*>(quality_),
                          static_cast<QWidget*>(width_), static_cast<QWidget*>(height_),
                          static_cast<QWidget*>(browse_), static_cast<QWidget*>(export_)}) {
    widget->setEnabled(!busy);
  }
  progress_->setVisible(busy);
  progress_->setValue(0);
  close_->setText(busy ? tr("Cancel") : tr("Close"));
}

void ExportDialog::reject() {
  if (job_ && job_->is_silent()) {
    return end(false, tr("The device did not answer, and the picture was given up."));
  }
  if (job_) {
    job_->cancel();
    message_->setText(tr("Cancelling…"));
    return;
  }
  QDialog::reject();
}

}  // namespace aerostat::viewer
