#pragma once

#include <QString>
#include <QStringList>
#include <vector>

#include "scene/film.hpp"

/// Changes to the keys of a film. They take and return the JSON text of /film/keys.
namespace aerostat::viewer {

/// Keys nearer to each other than this count as one, in seconds.
inline constexpr double kSameKey_s = 1e-4;

/// Returns the keys with one more key of the value at a pointer, which replaces one at the same
/// time. `value` is JSON, or else stands for the text itself.
QString with_key(const QString& keys, const QString& pointer, double time_s, const QString& value);

/// Returns the keys without the key of a value at a time. A value without any key is left out.
QString without_key(const QString& keys, const QString& pointer, double time_s);

/// Returns whether a value has a key at a time.
bool has_key(const std::vector<scene::KeyTrack>& tracks, const QString& pointer, double time_s);

/// Returns the pointers of the values that have keys, then those of values that films move often,
/// and then those of all other values with a control that keys can move.
QStringList values_for_keys(const std::vector<scene::KeyTrack>& tracks);

}  // namespace aerostat::viewer
