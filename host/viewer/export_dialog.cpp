#include "viewer/export_dialog.hpp"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>
#include <utility>

#include "core/file.hpp"
#include "scene/scene.hpp"
#include "viewer/export_job.hpp"

namespace aerostat::viewer {
namespace {

WholeBox* pixels_box(int value) {
  auto* box = new WholeBox;
  box->setRange(1, 32768);
  box->setSuffix(ExportDialog::tr(" px"));
  box->setValue(value);
  return box;
}

}  // namespace

ExportDialog::ExportDialog(const Document& document, const QString& device, QWidget* parent)
    : OutputDialog(
          document, device,
          {tr("Export Picture"), QStringLiteral("png"),
           tr("Pictures (*.png)") + ";;" + tr("OpenEXR (*.exr)"),
           tr("This is the scene file itself; give the picture another name."), tr("Cancelled"),
           tr("The device has not answered for %1 s. Cancel gives the picture up."),
           tr("The device did not answer, and the picture was given up.")},
          parent),
      width_(pixels_box(document.scene().image.width)),
      height_(pixels_box(document.scene().image.height)) {
  add_scene_qualities();
  set_quality(QStringLiteral("final"));
  auto* size = new QWidget;
  auto* row = new QHBoxLayout(size);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(width_);
  row->addWidget(new QLabel(QStringLiteral("×")));
  row->addWidget(height_);
  row->addStretch(1);
  add_row(tr("Size"), size);
  lay_out(tr("A name that ends in .exr keeps the light as it is, with distances, "
             "normals and objects in layers; any other gives a PNG."),
          520);
}

/// Returns the changes that give the scene the size of the dialog.
std::vector<scene::Override> ExportDialog::changes() const {
  return {{"/image/width", std::to_string(width_->value())},
          {"/image/height", std::to_string(height_->value())}};
}

bool ExportDialog::is_ready() {
  for (WholeBox* box : {width_, height_}) {
    if (!box->is_readable()) {
      tell(tr("Size: %1").arg(box->expected()));
      return false;
    }
    // The shortcut Alt+E does not move the focus, so the text of a box may still have to be read.
    box->interpretText();
  }
  return true;
}

void ExportDialog::start(const QString& path) {
  const scene::Scene scene = in_quality(document().source().with(changes())).scene();
  auto job = ExportJob::make();
  ExportJob& started = *job;
  connect(
      job.get(), &ExportJob::obstructed, this,
      [this, path](const QByteArray& bytes) { ask_about_file(path, bytes); }, Qt::QueuedConnection);
  follow(std::move(job));
  started.start(scene, path, device());
}

/// Asks what to do with a finished picture if another program wrote its file while the picture was
/// rendered.
void ExportDialog::ask_about_file(QString path, const QByteArray& bytes) {
  if (!is_busy()) return;
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
    write_file(path.toStdString(), {reinterpret_cast<const std::uint8_t*>(bytes.constData()),
                                    static_cast<std::size_t>(bytes.size())});
    end(true, tr("Wrote %1").arg(QDir::toNativeSeparators(path)));
  } catch (const std::exception& error) {
    end(false, QString::fromUtf8(error.what()));
  }
}

}  // namespace aerostat::viewer
