#pragma once

#include <QObject>
#include <memory>
#include <optional>

#include "viewer/camera_motion.hpp"
#include "viewer/document.hpp"
#include "viewer/render_thread.hpp"

class QPointF;

namespace aerostat::viewer {

enum class ViewKind { outside, basket, free };

/// Moves the camera of the document. Each movement starts from the camera of the last preview.
class CameraControl : public QObject {
  Q_OBJECT

 public:
  explicit CameraControl(Document& document, QObject* parent = nullptr);

  /// Remembers what was rendered last: the camera above the sea, and the ground.
  void note(std::shared_ptr<const Shown> shown) { shown_ = std::move(shown); }

  ViewKind kind() const;
  void set_kind(ViewKind kind);

  void orbit_by(double right, double down);
  void look_by(double right, double down);
  void dolly_by(double factor);
  void fly_by(const Flight& flight, double seconds, bool fast);
  /// Aims the camera at what is seen at a place of the picture.
  void aim_at(const QPointF& place);
  /// Puts a balloon above what is seen at a place of the picture, at its present height above the
  /// ground. `pointer` names the balloon and is that of the first one by default.
  void put_balloon(const QPointF& place, const QString& pointer = QStringLiteral("/balloon"));
  /// Returns the place of the first balloon above the sea, as far as it is known yet.
  dvec3 balloon_place() const;
  void apply_preset(int index);
  /// Takes over the camera of another scene.
  void take_camera_of(const QString& name, const scene::SceneSource& other);
  static QStringList preset_names();

  /// Returns the pose of the camera, or nothing if it is not known yet.
  std::optional<Pose> pose() const;
  std::optional<double> height_above_ground() const;

 private:
  bool is_absolute() const;
  void move_to(const QString& what, Pose pose, bool keep_basket);
  std::optional<dvec3> point_at(const QPointF& place) const;
  double radians_for(double share) const;

  Document& document_;
  std::shared_ptr<const Shown> shown_;
};

}  // namespace aerostat::viewer
