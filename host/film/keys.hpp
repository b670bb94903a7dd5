#pragma once

#include <optional>
#include <string>
#include <vector>

#include "scene/film.hpp"
#include "scene/io.hpp"

/// The keys of a film: values of a scene that change in time.
namespace aerostat::film {

/// Returns the share of the way from one key to the next at the share `t`, 0 to 1, of the time.
double eased(scene::Easing ease, double t);

/// Returns the angle at a share of the shorter way from `a` to `b`, in degrees. It may be outside
/// of a full circle.
double angle_between(double a_deg, double b_deg, double share);

/// Returns the changes, as "--set" makes them, that bring all values of the keys to a time.
std::vector<scene::Override> changes_at(const std::vector<scene::KeyTrack>& tracks, double time_s);

/// Returns the number that the keys give to the element `index` of an array at a time: by a track
/// of the array or of the element. Returns nothing if no track moves it.
std::optional<double> element_at(const std::vector<scene::KeyTrack>& tracks,
                                 const std::string& array, int index, double time_s);

/// Returns whether a track moves the value at a pointer, a part of it, or what it is a part of.
bool is_moved(const std::vector<scene::KeyTrack>& tracks, const std::string& pointer);

}  // namespace aerostat::film
