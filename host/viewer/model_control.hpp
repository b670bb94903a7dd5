#pragma once

#include <QObject>
#include <QPointF>
#include <QString>
#include <memory>
#include <optional>

#include "viewer/document.hpp"
#include "viewer/render_thread.hpp"

namespace aerostat::viewer {

/// What can be done with a file that is dropped on the window.
enum class DroppedFile { model, picture, scene };

/// Tells by the ending of its name what a file is. Anything but a model and a picture is opened as
/// a scene or as elevation data.
DroppedFile dropped_file(const QString& path);

/// Puts models from files into the scene, and moves and turns them there. Puts pictures on
/// envelopes. Places of the picture have both coordinates from 0 to 1.
class ModelControl : public QObject {
  Q_OBJECT

 public:
  explicit ModelControl(Document& document, QObject* parent = nullptr);

  /// Remembers what was rendered last.
  void note(std::shared_ptr<const Shown> shown) { shown_ = std::move(shown); }

  /// Adds a model that stands on the ground at a place of the picture, and picks it. Reports
  /// `refused` if no ground is seen there.
  bool put_model(const QString& file, const QPointF& place);
  /// Returns whether an envelope is seen at a place of the picture.
  bool is_envelope(const QPointF& place) const;
  /// Lays a picture as a motif on the envelope that is seen at a place of the picture, and reports
  /// `refused` if that envelope has no artwork. Returns the pointer of the artwork, or an empty
  /// string if there is none.
  QString put_artwork(const QString& file, const QPointF& place);

  /// Returns the number in Scene::objects of the model that is seen at a place of the picture.
  std::optional<int> model_at(const QPointF& place) const;

  /// The model that the mouse moves, if there is one.
  std::optional<int> picked() const { return picked_; }
  void pick(std::optional<int> model);
  /// Moves the picked model to the ground at a place of the picture.
  void move_to(const QPointF& place);
  /// Turns the picked model by a share of half a turn.
  void turn_by(double share);
  /// Removes the picked model from the scene.
  void remove();

  /// Returns where the foot of the picked model is in the picture, or nothing if it is not in view
  /// or not known yet.
  std::optional<QPointF> mark() const;
  /// Returns the name of the picked model's file.
  QString picked_name() const;

 Q_SIGNALS:
  void picked_changed();
  void refused(const QString& message);

 private:
  std::optional<std::size_t> pixel_at(const QPointF& place) const;
  std::uint32_t object_id_at(const QPointF& place) const;
  std::optional<dvec3> point_at(const QPointF& place) const;
  std::optional<dvec3> ground_at(const QPointF& place) const;
  QString pointer_of_picked() const;
  bool is_known() const;
  void follow();

  Document& document_;
  std::shared_ptr<const Shown> shown_;
  std::optional<int> picked_;
};

}  // namespace aerostat::viewer
