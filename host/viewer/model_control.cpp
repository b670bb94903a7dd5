#include "viewer/model_control.hpp"

#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QRectF>
#include <algorithm>
#include <cmath>

#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "viewer/camera_motion.hpp"
#include "world/pick.hpp"

namespace aerostat::viewer {
namespace {

/// Returns a value rounded to a centimetre or a hundredth of a degree.
double rounded(double value) {
  return std::round(value * 100.0) / 100.0 + 0.0;
}

std::string text_of(const QJsonValue& value) {
  const QJsonDocument document =
      value.isArray() ? QJsonDocument(value.toArray()) : QJsonDocument(value.toObject());
  return document.toJson(QJsonDocument::Compact).toStdString();
}

QJsonArray place_json(const dvec3& place) {
  return {rounded(place.x), rounded(place.y), rounded(place.z)};
}

double aspect_of(const scene::Scene& scene) {
  return static_cast<double>(scene.image.width) / scene.image.height;
}

bool is_ground(std::uint32_t id) {
  return id == static_cast<std::uint32_t>(scene::ObjectId::terrain) ||
         id == static_cast<std::uint32_t>(scene::ObjectId::water);
}

}  // namespace

DroppedFile dropped_file(const QString& path) {
  const QString ending = QFileInfo(path).suffix().toLower();
  for (const char* model : {"glb", "gltf", "obj", "ply", "stl"}) {
    if (ending == QLatin1String(model)) return DroppedFile::model;
  }
  for (const char* picture : {"png", "jpg", "jpeg", "svg"}) {
    if (ending == QLatin1String(picture)) return DroppedFile::picture;
  }
  return DroppedFile::scene;
}

ModelControl::ModelControl(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
  connect(&document, &Document::changed, this, &ModelControl::follow);
  connect(&document, &Document::file_changed, this, [this] {
    if (!is_known()) pick({});
  });
}

bool ModelControl::is_known() const {
  return picked_ && *picked_ < static_cast<int>(document_.scene().objects.size());
}

/// Drops the pick of a model that an undo removed.
void ModelControl::follow() {
  if (picked_ && !is_known()) pick({});
}

std::optional<std::size_t> ModelControl::pixel_at(const QPointF& place) const {
  if (!shown_) return std::nullopt;
  const image::Film& film = shown_->preview.film;
  if (film.width <= 0 || film.object_id.size() == 0) return std::nullopt;
  if (!QRectF(0.0, 0.0, 1.0, 1.0).contains(place)) return std::nullopt;
  const int x = std::clamp(static_cast<int>(place.x() * film.width), 0, film.width - 1);
  const int y = std::clamp(static_cast<int>(place.y() * film.height), 0, film.height - 1);
  return static_cast<std::size_t>(y) * static_cast<std::size_t>(film.width) +
         static_cast<std::size_t>(x);
}

std::uint32_t ModelControl::object_id_at(const QPointF& place) const {
  const auto pixel = pixel_at(place);
  return pixel ? shown_->preview.film.object_id.at(*pixel) : 0u;
}

std::optional<dvec3> ModelControl::point_at(const QPointF& place) const {
  const auto pixel = pixel_at(place);
  if (!pixel) return std::nullopt;
  const scene::Scene& seen = *shown_->preview.scene;
  const auto distance = static_cast<double>(shown_->preview.film.distance_m.at(*pixel));
  if (!std::isfinite(distance)) return std::nullopt;
  const Sight sight = sight_at(seen.camera, aspect_of(seen), place.x(), place.y());
  return sight.origin + sight.direction * distance;
}

/// Returns where a ray through the picture meets the ground, also behind what stands before it.
std::optional<dvec3> ModelControl::ground_at(const QPointF& place) const {
  if (is_ground(object_id_at(place))) return point_at(place);
  if (!shown_) return std::nullopt;
  const scene::Scene& seen = *shown_->preview.scene;
  const Sight sight = sight_at(seen.camera, aspect_of(seen), place.x(), place.y());
  const world::Surface& surface = *shown_->preview.surface;
  const auto distance =
      world::distance_to_ground(sight.origin, sight.direction,
                                [&surface](double x, double z) { return surface.height(x, z); });
  if (!distance) return std::nullopt;
  const dvec3 found = sight.origin + sight.direction * *distance;
  const double half = 0.5 * seen.terrain.size_m;
  const dvec2 from_middle = glm::abs(dvec2(found.x, found.z) - seen.terrain.center);
  if (std::max(from_middle.x, from_middle.y) > half) return std::nullopt;
  return found;
}

bool ModelControl::put_model(const QString& file, const QPointF& place) {
  const QString name = QFileInfo(file).fileName();
  if (!shown_) {
    Q_EMIT refused(tr("%1 can be put into the picture as soon as there is one.").arg(name));
    return false;
  }
  const auto at = ground_at(place);
  if (!at) {
    Q_EMIT refused(tr("%1 fell into the sky. Drop it where the ground is seen.").arg(name));
    return false;
  }
  const auto number = static_cast<int>(document_.scene().objects.size());
  const QJsonObject model{{"file", QFileInfo(file).absoluteFilePath()},
                          {"position", place_json({at->x, 0.0, at->z})}};
  document_.end_gesture();
  const bool is_put = document_.change(tr("Put %1").arg(name),
                                       {{"/objects/" + std::to_string(number), text_of(model)}});
  document_.end_gesture();
  if (is_put) pick(number);
  return is_put;
}

bool ModelControl::is_envelope(const QPointF& place) const {
  return object_id_at(place) == static_cast<std::uint32_t>(scene::ObjectId::envelope);
}

QString ModelControl::put_artwork(const QString& file, const QPointF& place) {
  const QString name = QFileInfo(file).fileName();
  const auto at = point_at(place);
  if (!is_envelope(place) || !at) return {};
  const scene::Scene& seen = *shown_->preview.scene;
  const auto number = world::balloon_at(seen, *at);
  // The balloons of a festival have no entry in the scene.
  if (!number || *number > document_.scene().balloons.size()) {
    Q_EMIT refused(tr("Balloons of a festival have no artwork."));
    return {};
  }
  const scene::Balloon& balloon = *number == 0 ? seen.balloon : seen.balloons[*number - 1];
  if (balloon.envelope) {
    Q_EMIT refused(tr("An envelope of a special shape has no artwork."));
    return {};
  }
  const world::ClothPlace cloth = world::cloth_place(balloon, *at);
  const std::string owner = *number == 0 ? "/balloon" : "/balloons/" + std::to_string(*number - 1);
  const std::string pointer = owner + "/artwork/" + std::to_string(balloon.artwork.size());
  const QJsonObject artwork{{"file", QFileInfo(file).absoluteFilePath()},
                            {"wrap", "motif"},
                            {"around_deg", rounded(cloth.around_deg)},
                            {"height_m", rounded(cloth.height_m)}};
  document_.end_gesture();
  const bool is_put = document_.change(tr("Put %1").arg(name), {{pointer, text_of(artwork)}});
  document_.end_gesture();
  return is_put ? QString::fromStdString(pointer) : QString();
}

std::optional<int> ModelControl::model_at(const QPointF& place) const {
  if (object_id_at(place) != static_cast<std::uint32_t>(scene::ObjectId::model)) return {};
  const auto at = point_at(place);
  if (!at || !shown_->preview.models) return {};
  const auto found = world::object_at(*shown_->preview.scene, *shown_->preview.models, *at);
  if (!found || *found >= document_.scene().objects.size()) return {};
  return static_cast<int>(*found);
}

void ModelControl::pick(std::optional<int> model) {
  if (model == picked_) return;
  picked_ = model;
  Q_EMIT picked_changed();
}

QString ModelControl::pointer_of_picked() const {
  return QStringLiteral("/objects/%1").arg(*picked_);
}

void ModelControl::move_to(const QPointF& place) {
  const auto at = ground_at(place);
  if (!at || !is_known()) return;
  const scene::PlacedModel& model = document_.scene().objects[static_cast<std::size_t>(*picked_)];
  // A height above the sea stays as it is.
  const dvec3 position(at->x, model.position.y, at->z);
  document_.change(
      tr("Move %1").arg(picked_name()),
      {{pointer_of_picked().toStdString() + "/position", text_of(place_json(position))}});
}

void ModelControl::turn_by(double share) {
  if (!is_known()) return;
  const scene::PlacedModel& model = document_.scene().objects[static_cast<std::size_t>(*picked_)];
  const double heading = std::remainder(model.heading_deg + 180.0 * share, 360.0);
  document_.change(tr("Turn %1").arg(picked_name()),
                   {{pointer_of_picked().toStdString() + "/heading_deg",
                     QString::number(rounded(heading), 'g', 12).toStdString()}});
}

void ModelControl::remove() {
  if (!is_known()) return;
  const QString what = tr("Remove %1").arg(picked_name());
  QJsonArray all = QJsonDocument::fromJson(document_.value("/objects").toUtf8()).array();
  all.removeAt(*picked_);
  pick({});
  document_.end_gesture();
  if (all.isEmpty()) {
    document_.reset(what, {QStringLiteral("/objects")});
  } else {
    document_.change(what, {{"/objects", text_of(all)}});
  }
  document_.end_gesture();
}

std::optional<QPointF> ModelControl::mark() const {
  if (!is_known() || !shown_) return {};
  const scene::Scene& seen = *shown_->preview.scene;
  const auto number = static_cast<std::size_t>(*picked_);
  if (number >= seen.objects.size()) return {};
  dvec3 foot = document_.scene().objects[number].position;
  if (seen.objects[number].height_above == scene::HeightReference::ground) {
    foot.y += shown_->preview.surface->height(foot.x, foot.z);
  }
  const auto place = place_in_picture(seen.camera, aspect_of(seen), foot);
  if (!place) return {};
  return QPointF(place->x, place->y);
}

QString ModelControl::picked_name() const {
  if (!is_known()) return {};
  const auto& objects = document_.scene().objects;
  const std::string& file = objects[static_cast<std::size_t>(*picked_)].file;
  return QFileInfo(QString::fromStdString(file)).fileName();
}

}  // namespace aerostat::viewer
