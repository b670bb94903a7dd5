#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "elevation/open.hpp"
#include "viewer/main_window.hpp"
#include "viewer/message_bar.hpp"
#include "viewer/panels.hpp"
#include "viewer/picture_view.hpp"
#include "viewer/scene_files.hpp"

namespace aerostat::viewer {

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.size() != 1 || !urls.front().isLocalFile()) return;
  // A pipe is refused, because the window would wait for its writer. A folder is accepted, so that
  // opening it can report that it is not a file.
  const QFileInfo file(urls.front().toLocalFile());
  if (file.isFile() || file.isDir()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  const auto urls = event->mimeData()->urls();
  if (urls.isEmpty()) return;
  const QPoint at = view_->viewport()->mapFrom(this, event->position().toPoint());
  const bool on_picture = view_->viewport()->rect().contains(at);
  take_file(urls.front().toLocalFile(), on_picture ? view_->place_at(at) : std::nullopt);
}

void MainWindow::connect_models() {
  connect(&models_, &ModelControl::refused, this,
          [this](const QString& message) { messages_->show_message(message); });
  connect(&models_, &ModelControl::picked_changed, this, [this] {
    if (const auto picked = models_.picked()) {
      panels_->show_model(QStringLiteral("/objects/%1").arg(*picked));
    }
    show_mark();
  });
  connect(&document_, &Document::changed, this, &MainWindow::show_mark);
  connect(&panels_->models(), &ItemPicker::file_asked, this, &MainWindow::ask_for_model);
  view_->set_grab([this](const QPointF& place) {
    return models_.picked() && models_.model_at(place) == models_.picked();
  });
  connect(view_, &PictureView::clicked, this,
          [this](const QPointF& place) { models_.pick(models_.model_at(place)); });
  connect(view_, &PictureView::carried, &models_, &ModelControl::move_to);
  connect(view_, &PictureView::turned, &models_, &ModelControl::turn_by);
  connect(view_, &PictureView::removal_asked, &models_, &ModelControl::remove);
  connect(view_, &PictureView::mark_dropped, &models_, [this] { models_.pick({}); });
}

void MainWindow::show_mark() {
  view_->set_mark(models_.mark(), models_.picked_name());
}

void MainWindow::take_file(const QString& path, const std::optional<QPointF>& place) {
  messages_->dismiss();
  const QString name = QFileInfo(path).fileName();
  switch (dropped_file(path)) {
    case DroppedFile::model:
      if (place) {
        models_.put_model(path, *place);
      } else {
        messages_->show_message(tr("Drop %1 on the picture, where it shall stand.").arg(name));
      }
      break;
    case DroppedFile::picture:
      put_artwork(path, place);
      break;
    case DroppedFile::scene:
      files_->open(path);
      break;
  }
}

void MainWindow::put_artwork(const QString& path, const std::optional<QPointF>& place) {
  const QString name = QFileInfo(path).fileName();
  if (place && models_.is_envelope(*place)) {
    const QString pointer = models_.put_artwork(path, *place);
    if (!pointer.isEmpty()) offer_wraps(name, pointer);
    return;
  }
  std::vector<MessageBar::Offer> offers;
  if (elevation::is_elevation(path.toStdString())) {
    offers.push_back({tr("Open as Elevation Data"), [this, path] { files_->open(path); }});
  }
  messages_->show_message(
      tr("%1 can be dropped on an envelope, where it becomes artwork.").arg(name), offers);
}

/// Says that a picture lies on the envelope, and offers the other ways in which it can lie there.
void MainWindow::offer_wraps(const QString& name, const QString& pointer) {
  const auto lay = [this, pointer](const QString& what, const QString& wrap) {
    QJsonObject artwork = QJsonDocument::fromJson(document_.value(pointer).toUtf8()).object();
    // Only a motif has a height of its middle.
    artwork.remove(QStringLiteral("height_m"));
    artwork[QStringLiteral("wrap")] = wrap;
    document_.end_gesture();
    document_.set(what, pointer,
                  QString::fromUtf8(QJsonDocument(artwork).toJson(QJsonDocument::Compact)));
  };
  messages_->show_message(tr("%1 lies on the envelope.").arg(name),
                          {{tr("As a Band"), [lay] { lay(tr("Artwork as a Band"), "band"); }},
                           {tr("All Around"), [lay] { lay(tr("Artwork All Around"), "whole"); }}});
}

void MainWindow::ask_for_model() {
  const QString folder = QFileInfo(document_.path()).absolutePath();
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Put a Model"), folder,
      tr("Models (*.glb *.gltf *.obj *.ply *.stl)") + ";;" + SceneFiles::tr("All files (*)"));
  // The ground is usually in the lower half of the picture.
  if (!path.isEmpty()) models_.put_model(path, QPointF(0.5, 0.75));
}

}  // namespace aerostat::viewer
