#include "viewer/output_dialog.hpp"

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
#include <utility>

#include "core/file.hpp"
#include "viewer/controls.hpp"
#include "viewer/screen_fit.hpp"

namespace aerostat::viewer {
namespace {

QString suggested_path(const Document& document, const QString& suffix) {
  const QFileInfo file(document.path());
  const bool is_unnamed = document.path().isEmpty();
  const QString name = is_unnamed ? QStringLiteral("aerostat") : file.completeBaseName();
  const QString folder = is_unnamed ? QDir::currentPath() : file.absolutePath();
  return folder + "/" + name + "." + suffix;
}

}  // namespace

OutputDialog::OutputDialog(const Document& document, const QString& device, Words words,
                           QWidget* parent)
    : QDialog(parent),
      document_(document),
      device_(device),
      words_(std::move(words)),
      inputs_(new QWidget),
      form_(new QFormLayout(inputs_)),
      path_(new QLineEdit(suggested_path(document, words_.suffix))),
      quality_(new QComboBox),
      progress_(new QProgressBar),
      message_(new QLabel),
      export_(new QPushButton(tr("&Export"))),
      close_(new QPushButton(tr("Close"))) {
  setWindowTitle(words_.title);
  auto* browse = new QPushButton(tr("&Browse…"));
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, &OutputDialog::choose_path);
  auto* file = new QHBoxLayout;
  file->addWidget(path_, 1);
  file->addWidget(browse);
  form_->setContentsMargins(0, 0, 0, 0);
  form_->addRow(tr("File"), file);
  form_->addRow(tr("Quality"), quality_);
  export_->setDefault(true);
  connect(export_, &QPushButton::clicked, this, &OutputDialog::begin);
  connect(close_, &QPushButton::clicked, this, &OutputDialog::reject);
}

void OutputDialog::add_quality(const QString& text, const QString& word) {
  quality_->addItem(text, word);
}

void OutputDialog::add_scene_qualities() {
  for (const char* name : {"draft", "standard", "final"}) {
    const QString word = QString::fromLatin1(name);
    add_quality(word_text(word), word);
  }
  add_quality(tr("As the scene says"), {});
}

QString OutputDialog::quality() const {
  return quality_->currentData().toString();
}

void OutputDialog::add_row(const QString& label, QWidget* row) {
  form_->addRow(label, row);
}

void OutputDialog::lay_out(const QString& hint, int width) {
  auto* words = new QLabel(hint);
  words->setWordWrap(true);
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
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(inputs_);
  layout->addWidget(words);
  layout->addWidget(progress_);
  layout->addWidget(message_);
  layout->addStretch(1);
  layout->addLayout(buttons);
  resize_to_fit(*this, QSize(width, sizeHint().height()));
}

void OutputDialog::set_path(const QString& path) {
  path_->setText(path);
  agreed_path_ = path;
}

void OutputDialog::set_quality(const QString& quality) {
  quality_->setCurrentIndex(quality_->findData(quality));
}

QString OutputDialog::message() const {
  return message_->text();
}

void OutputDialog::tell(const QString& message) {
  message_->setText(message);
}

void OutputDialog::choose_path() {
  const QString path =
      QFileDialog::getSaveFileName(this, words_.title, path_->text(), words_.filter);
  // The file dialog has already asked whether to replace the file.
  if (!path.isEmpty()) set_path(path);
}

/// Returns whether a file may be written. The scene file itself may not, and an older file only
/// after a question.
bool OutputDialog::may_write(const QString& path) {
  if (is_same_file(path.toStdString(), document_.path().toStdString())) {
    tell(words_.is_scene);
    return false;
  }
  if (path == agreed_path_ || !QFileInfo(path).isFile()) return true;
  const auto answer = QMessageBox::question(
      this, words_.title, tr("%1 already exists. Replace it?").arg(QFileInfo(path).fileName()));
  if (answer != QMessageBox::Yes) return false;
  agreed_path_ = path;
  return true;
}

scene::SceneSource OutputDialog::in_quality(const scene::SceneSource& source) const {
  if (quality().isEmpty()) return source;
  return source.without({"/image/spp", "/sun/soft_shadows", "/sky/ambient_occlusion"})
      .with({{"/quality", quality().toStdString()}});
}

void OutputDialog::begin() {
  if (job_ || !is_ready()) return;
  QString path = path_->text().trimmed();
  if (path.isEmpty()) return;
  const QFileInfo file(path);
  // A path such as "folder/" gets no suffix, so it is refused.
  if (file.suffix().isEmpty() && !file.fileName().isEmpty()) path += "." + words_.suffix;
  if (!may_write(path)) return;
  message_->clear();
  try {
    start(path);
  } catch (const std::exception& error) {
    job_.reset();
    set_busy(false);
    tell(QString::fromUtf8(error.what()));
  }
}

void OutputDialog::follow(OutputJob::Handle job) {
  job_ = std::move(job);
  connect(job_.get(), &OutputJob::progressed, this, &OutputDialog::show_progress,
          Qt::QueuedConnection);
  connect(job_.get(), &OutputJob::finished, this, &OutputDialog::end, Qt::QueuedConnection);
  connect(
      job_.get(), &OutputJob::fell_silent, this,
      [this](int seconds) { tell(words_.silent.arg(seconds)); }, Qt::QueuedConnection);
  set_busy(true);
}

void OutputDialog::show_progress(double fraction, const QString& text) {
  progress_->setValue(static_cast<int>(fraction * 1000.0));
  progress_->setFormat(text + QStringLiteral(" (%p %)"));
}

void OutputDialog::end(bool written, const QString& message) {
  if (!job_) return;
  job_.reset();
  set_busy(false);
  tell(message.isEmpty() ? words_.cancelled : message);
  Q_EMIT ended(written);
}

void OutputDialog::set_busy(bool busy) {
  // The focus would otherwise move to an arbitrary widget after the disabled one.
  if (busy) close_->setFocus();
  inputs_->setEnabled(!busy);
  export_->setEnabled(!busy);
  progress_->setVisible(busy);
  progress_->setValue(0);
  close_->setText(busy ? tr("Cancel") : tr("Close"));
}

void OutputDialog::reject() {
  if (job_ && job_->is_silent()) {
    end(false, words_.given_up);
    return;
  }
  if (job_) {
    job_->cancel();
    tell(tr("Cancelling…"));
    return;
  }
  QDialog::reject();
}

}  // namespace aerostat::viewer
