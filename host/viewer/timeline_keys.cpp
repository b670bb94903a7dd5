#include "viewer/timeline_keys.hpp"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>
#include <cmath>

#include "scene/film_semantics.hpp"
#include "viewer/controls.hpp"

namespace aerostat::viewer {
namespace {

QJsonArray read(const QString& text) {
  return QJsonDocument::fromJson(text.toUtf8()).array();
}

QString written(const QJsonArray& array) {
  return QString::fromUtf8(QJsonDocument(array).toJson(QJsonDocument::Compact));
}

/// Returns a value of JSON. Text that is no JSON is a word or a time of day.
QJsonValue value_of(const QString& text) {
  const QJsonArray one = read("[" + text + "]");
  return one.size() == 1 ? one[0] : QJsonValue(text.trimmed());
}

bool is_at(const QJsonValue& key, double time_s) {
  return std::abs(key["time_s"].toDouble() - time_s) < kSameKey_s;
}

/// Returns the number of the track of a value, or that of all tracks if there is none.
qsizetype track_of(const QJsonArray& tracks, const QString& pointer) {
  qsizetype i = 0;
  while (i < tracks.size() && tracks[i]["value"].toString() != pointer) ++i;
  return i;
}

}  // namespace

QString with_key(const QString& keys, const QString& pointer, double time_s, const QString& value) {
  QJsonArray tracks = read(keys);
  const qsizetype at = track_of(tracks, pointer);
  if (at == tracks.size()) tracks.append(QJsonObject{{"value", pointer}});
  QJsonObject track = tracks[at].toObject();
  QJsonArray list = track["keys"].toArray();
  qsizetype place = 0;
  while (place < list.size() && list.at(place)["time_s"].toDouble() < time_s - kSameKey_s) ++place;
  if (place < list.size() && is_at(list.at(place), time_s)) list.removeAt(place);
  list.insert(place, QJsonObject{{"time_s", time_s}, {"is", value_of(value)}});
  track["keys"] = list;
  tracks[at] = track;
  return written(tracks);
}

QString without_key(const QString& keys, const QString& pointer, double time_s) {
  QJsonArray tracks = read(keys);
  const qsizetype at = track_of(tracks, pointer);
  if (at == tracks.size()) return keys;
  QJsonObject track = tracks[at].toObject();
  QJsonArray left;
  for (const QJsonValue& key : track["keys"].toArray()) {
    if (!is_at(key, time_s)) left.append(key);
  }
  track["keys"] = left;
  if (left.isEmpty()) {
    tracks.removeAt(at);
  } else {
    tracks[at] = track;
  }
  return written(tracks);
}

bool has_key(const std::vector<scene::KeyTrack>& tracks, const QString& pointer, double time_s) {
  return std::any_of(tracks.begin(), tracks.end(), [&](const scene::KeyTrack& track) {
    return track.value == pointer.toStdString() &&
           std::any_of(track.keys.begin(), track.keys.end(), [time_s](const scene::Key& key) {
             return std::abs(key.time_s - time_s) < kSameKey_s;
           });
  });
}

QStringList values_for_keys(const std::vector<scene::KeyTrack>& tracks) {
  QStringList values;
  for (const scene::KeyTrack& track : tracks) values << QString::fromStdString(track.value);
  // What films move most often comes next. Some of these values have no control.
  for (const char* often :
       {"/balloon/position/1", "/balloon/heading_deg", "/balloon/burner", "/balloon/position",
        "/camera/position", "/camera/target", "/camera/fov_y_deg", "/sun/elevation_deg",
        "/sun/azimuth_deg", "/sun/time"}) {
    const QString pointer = QString::fromLatin1(often);
    if (!values.contains(pointer)) values << pointer;
  }
  for (const Control& control : controls()) {
    const QString pointer = QString::fromStdString(control.pointer);
    if (scene::key_kind(control.pointer) && !values.contains(pointer)) values << pointer;
  }
  return values;
}

}  // namespace aerostat::viewer
