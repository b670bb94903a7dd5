#include "viewer/camera_control.hpp"

#include <QCoreApplication>
#include <QPointF>
#include <QStringList>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/scene.hpp"
#include "viewer/scene_presets.hpp"

namespace aerostat::viewer {
namespace {

using scene::HeightReference;
using scene::Override;

/// The distance of the sky in metres when the camera aims at it. Chosen by eye.
constexpr double kSkyDistance_m = 2000.0;

/// Returns a value as text, rounded to a centimetre, which is too fine to be seen.
std::string number(double value) {
  return QString::number(std::round(value * 100.0) / 100.0 + 0.0, 'g', 12).toStdString();
}

std::string point(const dvec3& p) {
  std::string text(1, '[');
  text.append(number(p.x)).append(", ").append(number(p.y)).append(", ").append(number(p.z));
  return text.append("]");
}

/// A camera given by its position and its target. Heights are counted from the basket's floor.
struct Preset {
  const char* name;
  dvec3 stand, look;
  double fov_y_deg;
};

constexpr Preset kPresets[] = {
    {QT_TRANSLATE_NOOP("Presets", "Near the balloon"), {-18.0, 6.0, 42.0}, {0.0, 9.0, 0.0}, 45.0},
    {QT_TRANSLATE_NOOP("Presets", "Far, the balloon small"),
     {-60.0, 20.0, 420.0},
     {60.0, 10.0, 0.0},
     40.0},
    {QT_TRANSLATE_NOOP("Presets", "From above"), {-50.0, 120.0, 60.0}, {0.0, 0.0, 0.0}, 50.0},
    {QT_TRANSLATE_NOOP("Presets", "From below"), {14.0, -60.0, 46.0}, {0.0, 12.0, 0.0}, 50.0},
    {QT_TRANSLATE_NOOP("Presets", "Against the other side"),
     {70.0, 8.0, -80.0},
     {-8.0, 8.0, 0.0},
     45.0},
};

}  // namespace

CameraControl::CameraControl(Document& document, QObject* parent)
    : QObject(parent), document_(document) {}

bool CameraControl::is_absolute() const {
  const scene::Camera& camera = document_.scene().camera;
  return camera.height_above == HeightReference::sea && camera.position && camera.target;
}

ViewKind CameraControl::kind() const {
  if (document_.scene().camera.view == scene::View::basket) return ViewKind::basket;
  const auto& source = document_.source();
  const bool moved = source.differs("/camera/position") || source.differs("/camera/target") ||
                     source.differs("/camera/height_above");
  return moved ? ViewKind::free : ViewKind::outside;
}

void CameraControl::set_kind(ViewKind kind) {
  document_.end_gesture();
  if (kind == ViewKind::free) {
    if (const auto now = pose()) move_to(tr("Free View"), *now, false);
    return;
  }
  const bool basket = kind == ViewKind::basket;
  const auto source = document_.source()
                          .without({"/camera/position", "/camera/target", "/camera/height_above",
                                    "/camera/fov_y_deg"})
                          .with({{"/camera/view", basket ? "basket" : "outside"}});
  document_.replace(basket ? tr("View from the Basket") : tr("View from Outside"), source);
}

std::optional<Pose> CameraControl::pose() const {
  const scene::Camera& camera = document_.scene().camera;
  if (is_absolute()) return Pose{*camera.position, *camera.target};
  if (!shown_) return std::nullopt;
  const scene::Camera& seen = shown_->preview.scene->camera;
  Pose pose{*seen.position, *seen.target};
  // The passenger was turned in the meantime. In the view from the basket, heights count from the
  // basket's floor.
  if (camera.view == scene::View::basket && camera.target &&
      camera.height_above == HeightReference::balloon) {
    pose.target = *camera.target;
    pose.target.y += shown_->preview.scene->balloon.position.y;
  }
  return pose;
}

std::optional<double> CameraControl::height_above_ground() const {
  const auto now = pose();
  if (!now || !shown_) return std::nullopt;
  return now->position.y - shown_->preview.surface->height(now->position.x, now->position.z);
}

/// Moves the camera to `pose`. If `keep_basket` is true and the view is that from the basket, only
/// the passenger turns; otherwise the camera becomes a free one.
void CameraControl::move_to(const QString& what, Pose pose, bool keep_basket) {
  const scene::Camera& camera = document_.scene().camera;
  if (keep_basket && camera.view == scene::View::basket && !camera.position && shown_) {
    pose.target.y -= shown_->preview.scene->balloon.position.y;
    document_.change(what,
                     {{"/camera/height_above", "balloon"}, {"/camera/target", point(pose.target)}});
    return;
  }
  if (shown_) {
    const auto& surface = *shown_->preview.surface;
    pose = above_ground(pose, [&surface](double x, double z) { return surface.height(x, z); });
  }
  document_.change(what, {{"/camera/view", "outside"},
                          {"/camera/fov_y_deg", number(camera.fov_y_deg)},
                          {"/camera/height_above", "sea"},
                          {"/camera/position", point(pose.position)},
                          {"/camera/target", point(pose.target)}});
}

/// Returns the angle of a drag by `share` of the picture's height. With this angle, what is dragged
/// stays under the mouse.
double CameraControl::radians_for(double share) const {
  return share * document_.scene().camera.fov_y_deg * (std::numbers::pi / 180.0);
}

void CameraControl::orbit_by(double right, double down) {
  if (kind() == ViewKind::basket) {
    look_by(right, down);
    return;
  }
  const auto now = pose();
  if (!now) return;
  // A drag across the picture's height is half a turn.
  move_to(tr("Orbit"), orbit(*now, right * std::numbers::pi, down * std::numbers::pi), false);
}

void CameraControl::look_by(double right, double down) {
  const auto now = pose();
  if (now) move_to(tr("Look Around"), look(*now, radians_for(right), radians_for(down)), true);
}

void CameraControl::dolly_by(double factor) {
  const scene::Camera& camera = document_.scene().camera;
  if (camera.lens == scene::Lens::orthographic) {
    // Parallel rays show the same picture from every point along the view, so the height of the
    // view changes instead of the distance.
    const QString height = QString::number(std::clamp(camera.view_height_m * factor, 0.1, 1e5));
    document_.set(tr("Move Closer or Away"), QStringLiteral("/camera/view_height_m"), height);
    return;
  }
  const auto now = pose();
  if (now) move_to(tr("Move Closer or Away"), dolly(*now, factor), false);
}

void CameraControl::fly_by(const Flight& flight, double seconds, bool fast) {
  const auto now = pose();
  if (!now) return;
  const double speed = flight_speed(height_above_ground().value_or(100.0)) * (fast ? 5.0 : 1.0);
  move_to(tr("Fly"), fly(*now, flight, speed * seconds), false);
}

std::optional<dvec3> CameraControl::point_at(const QPointF& place) const {
  if (!shown_) return std::nullopt;
  const image::Film& film = shown_->preview.film;
  const scene::Scene& seen = *shown_->preview.scene;
  const int x = std::clamp(static_cast<int>(place.x() * film.width), 0, film.width - 1);
  const int y = std::clamp(static_cast<int>(place.y() * film.height), 0, film.height - 1);
  const double aspect = static_cast<double>(seen.image.width) / seen.image.height;
  const Sight sight = sight_at(seen.camera, aspect, place.x(), place.y());
  const auto index = static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
                     static_cast<std::size_t>(x);
  const double distance = static_cast<double>(film.distance_m.at(index));
  if (!std::isfinite(distance)) return std::nullopt;
  return sight.origin + sight.direction * distance;
}

void CameraControl::aim_at(const QPointF& place) {
  const auto now = pose();
  if (!now || !shown_) return;
  document_.end_gesture();
  const scene::Scene& seen = *shown_->preview.scene;
  const double aspect = static_cast<double>(seen.image.width) / seen.image.height;
  const Sight sight = sight_at(seen.camera, aspect, place.x(), place.y());
  const dvec3 far = sight.origin + kSkyDistance_m * sight.direction;
  move_to(tr("Aim"), {now->position, point_at(place).value_or(far)}, true);
  document_.end_gesture();
}

void CameraControl::put_balloon(const QPointF& place, const QString& pointer) {
  const auto at = point_at(place);
  const auto now = pose();
  if (!at || !now) return;
  const scene::Scene& scene = *shown_->preview.scene;
  const bool first = pointer == QLatin1String("/balloon");
  const auto index = pointer.section(QLatin1Char('/'), 2, 2).toUInt();
  if (!first && index >= scene.balloons.size()) return;
  const scene::Balloon& seen = first ? scene.balloon : scene.balloons[index];
  const auto& surface = *shown_->preview.surface;
  const double height = seen.position.y - surface.height(seen.position.x, seen.position.z);
  const std::string name = pointer.toStdString();
  std::vector<Override> changes = {
      {name + "/enabled", "true"},
      {name + "/height_above", "ground"},
      {name + "/position", point({at->x, std::max(height, 0.0), at->z})}};
  // The view stays the same, although it was counted from the balloon.
  if (first && kind() != ViewKind::basket && !is_absolute()) {
    changes.push_back({"/camera/height_above", "sea"});
    changes.push_back({"/camera/position", point(now->position)});
    changes.push_back({"/camera/target", point(now->target)});
  }
  document_.end_gesture();
  document_.change(tr("Put the Balloon"), changes);
  document_.end_gesture();
}

dvec3 CameraControl::balloon_place() const {
  return shown_ ? shown_->preview.scene->balloon.position : document_.scene().balloon.position;
}

void CameraControl::take_camera_of(const QString& name, const scene::SceneSource& other) {
  document_.end_gesture();
  document_.replace(tr("Camera: %1").arg(name), with_camera_of(document_.source(), other));
  document_.end_gesture();
}

QStringList CameraControl::preset_names() {
  QStringList names;
  for (const Preset& preset : kPresets) {
    names << QCoreApplication::translate("Presets", preset.name);
  }
  return names;
}

void CameraControl::apply_preset(int index) {
  const Preset& preset = kPresets[index];
  const dvec3 balloon = document_.scene().balloon.position;
  const dvec3 below(balloon.x, 0.0, balloon.z);
  document_.end_gesture();
  document_.change(preset_names().at(index), {{"/camera/view", "outside"},
                                              {"/camera/height_above", "balloon"},
                                              {"/camera/position", point(below + preset.stand)},
                                              {"/camera/target", point(below + preset.look)},
                                              {"/camera/fov_y_deg", number(preset.fov_y_deg)}});
  document_.end_gesture();
}

}  // namespace aerostat::viewer
