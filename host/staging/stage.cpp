#include "staging/stage.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geo/transform.hpp"
#include "scene/enum_names.hpp"
#include "scene/scene.hpp"
#include "scene/sun_angles.hpp"
#include "staging/climate.hpp"
#include "staging/flight_point.hpp"
#include "staging/moment.hpp"
#include "staging/view_choice.hpp"
#include "staging/view_map.hpp"
#include "terrain/cover.hpp"
#include "terrain/drape.hpp"
#include "terrain/real_land.hpp"

namespace aerostat::staging {
namespace {

using scene::Override;

// Chosen by eye.
constexpr geo::Place kSomePlace{46.0, 10.0};   // whose climate land of unknown place has
constexpr double kSomeSunAzimuth_deg = 112.0;  // for land whose place is unknown

// The camera looks past the balloon from this far away, slightly down, so that the horizon is in
// the upper third. The distance is for a balloon of 18.8 m. All were chosen by eye.
constexpr double kStand_m = 104.0, kBalloonTurn_deg = 11.0, kDip_deg = 5.0;

constexpr double kUsualHeight_m = 150.0;  // of the balloon over the ground, where no view is found
constexpr double kMostExtent_m = 100000.0;  // of the land that a view is chosen in
constexpr double kNearExtent_m = 70000.0;   // around the best region of larger land
constexpr double kLeastGround_m = 9000.0, kMostGround_m = 160000.0;

dvec3 towards(double azimuth_deg) {
  const double azimuth = glm::radians(azimuth_deg);
  return {std::sin(azimuth), 0.0, -std::cos(azimuth)};
}

std::string list_of(const dvec3& v) {
  return fmt::format("[{:.1f}, {:.1f}, {:.1f}]", v.x, v.y, v.z);
}

class Stage {
 public:
  Stage(const scene::SceneSource& source, terrain::ReliefCache& reliefs)
      : source_(source),
        scene_(source.scene()),
        reliefs_(reliefs),
        land_(terrain::real_land(scene_.terrain, reliefs.lands)),
        middle_(terrain::middle_point(scene_.terrain, *land_)) {}

  /// Returns the scene with each of the `count` best views, or with the one that it gives.
  std::vector<Staged> run(int count) {
    notes_ = land_->notes();
    has_sea_ = gives("/biome/water/enabled") ? scene_.biome.water.enabled : land_->has_sea();
    settle_places();
    choose_sun();
    std::vector<Staged> all;
    const bool given = gives("/camera/position") || scene_.camera.at;
    if (given) all.push_back(finished());
    for (const ViewChoice& view : given ? std::vector<ViewChoice>() : find_views(count)) {
      Stage one = *this;
      one.apply(view);
      all.push_back(one.finished());
    }
    add_overlay_notes(all.front());
    return all;
  }

 private:
  bool gives(const std::string& pointer) const { return source_.gives(pointer); }

  void set(const std::string& pointer, const std::string& value) {
    if (!gives(pointer)) changes_.push_back({pointer, value});
  }
  void set(const std::string& pointer, double value) {
    set(pointer, fmt::format("{:.10g}", value));
  }

  /// Sets a value that the scene may give already.
  void replace(const std::string& pointer, const std::string& value) {
    changes_.push_back({pointer, value});
  }

  bool gives_balloon() const {
    return gives("/balloon/position") || scene_.balloon.at || scene_.balloon.track;
  }

  /// Turns places on the Earth into positions. The first of them becomes the middle of the ground
  /// if the scene names none.
  void settle_places() {
    const scene::Balloon& balloon = scene_.balloon;
    const scene::Camera& camera = scene_.camera;
    if (balloon.track) {
      flight_ = flight_point(*balloon.track, *land_);
      notes_.insert(notes_.end(), flight_->notes.begin(), flight_->notes.end());
      anchor(flight_->place);
    } else if (balloon.at) {
      anchor({balloon.at->latitude_deg, balloon.at->longitude_deg});
    } else if (camera.at) {
      anchor({camera.at->latitude_deg, camera.at->longitude_deg});
    } else {
      anchor_to_objects();
    }
    if (flight_) {
      put_flight("/balloon", *flight_);
    } else if (balloon.at) {
      put("/balloon/position", *balloon.at, balloon.height_above);
    }
    for (std::size_t i = 0; i < scene_.balloons.size(); ++i) {
      const scene::Balloon& further = scene_.balloons[i];
      const std::string pointer = fmt::format("/balloons/{}", i);
      if (further.track) {
        put_flight(pointer, flight_point(*further.track, *land_));
      } else if (further.at) {
        put(pointer + "/position", *further.at, further.height_above);
      }
    }
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
      const scene::PlacedModel& object = scene_.objects[i];
      if (!object.at) continue;
      put(fmt::format("/objects/{}/position", i), *object.at, object.height_above);
    }
    settle_lights();
    settle_camera();
  }

  /// Makes the place of the first model that has one the middle of the ground.
  void anchor_to_objects() {
    for (const scene::PlacedModel& object : scene_.objects) {
      if (object.at) return anchor({object.at->latitude_deg, object.at->longitude_deg});
    }
  }

  void settle_lights() {
    for (std::size_t i = 0; i < scene_.lights.size(); ++i) {
      const scene::PointLight& light = scene_.lights[i];
      if (!light.at) continue;
      const std::string pointer = fmt::format("/lights/{}", i);
      const bool given = gives(pointer + "/height_above");
      const auto reference = given ? light.height_above : scene::HeightReference::ground;
      set(pointer + "/height_above", "ground");
      put(pointer + "/position", *light.at, reference);
    }
  }

  void settle_camera() {
    const scene::Camera& camera = scene_.camera;
    if (!camera.at && !camera.look_at) return;
    const bool given = gives("/camera/height_above");
    const auto reference = given ? camera.height_above : scene::HeightReference::ground;
    set("/camera/height_above", "ground");
    if (camera.at) put("/camera/position", *camera.at, reference);
    if (camera.look_at) put("/camera/target", *camera.look_at, reference);
  }

  void anchor(const geo::Place& place) {
    if (!land_->has_place()) {
      throw Error(ErrorKind::bad_data,
                  "a place by latitude and longitude needs to know where the land lies; name the "
                  "coordinate reference system of the source by /terrain/crs");
    }
    if (gives("/terrain/place")) return;
    middle_ = {place, {}};
    set("/terrain/place/latitude_deg", place.latitude_deg);
    set("/terrain/place/longitude_deg", place.longitude_deg);
    anchored_ = true;
  }

  /// Sets a position to a place. Heights over the sea count from the plane that touches the Earth
  /// in the middle of the ground.
  void put(const std::string& pointer, const scene::GeoPoint& point,
           scene::HeightReference reference) {
    const dvec2 at = geo::local_point(*middle_.place, {point.latitude_deg, point.longitude_deg});
    const bool falls = reference == scene::HeightReference::sea && scene_.terrain.curved;
    const double drop = falls ? geo::curvature_drop(glm::length(at)) : 0.0;
    replace(pointer, fmt::format("[{:.2f}, {:.2f}, {:.2f}]", at.x, point.height_m - drop, at.y));
  }

  void put_flight(const std::string& balloon, const FlightPoint& flight) {
    replace(balloon + "/height_above", "sea");
    put(balloon + "/position",
        {flight.place.latitude_deg, flight.place.longitude_deg, flight.height_m},
        scene::HeightReference::sea);
  }

  void choose_sun() {
    const bool by_date = gives("/sun/date");
    const bool by_angle =
        gives("/sun/direction") || gives("/sun/azimuth_deg") || gives("/sun/elevation_deg");
    sun_azimuth_deg_ = scene::detail::angles_of(scene_.sun.direction).azimuth_deg;
    if (by_date) {
      month_ = month_of(source_.value("/sun/date"));
    } else if (!by_angle && middle_.place) {
      const Moment moment = flight_ && flight_->time_s ? moment_of(*flight_->time_s, *middle_.place)
                                                       : morning_at(*middle_.place);
      sun_azimuth_deg_ = moment.azimuth_deg;
      month_ = month_of(moment.date);
      set("/sun/date", moment.date);
      set("/sun/time", moment.time);
      set("/sun/latitude_deg", middle_.place->latitude_deg);
      set("/sun/longitude_deg", middle_.place->longitude_deg);
      notes_.push_back(fmt::format(
          "No sun is given; it is that of {}, {}. /sun/date and /sun/time choose another.",
          moment.date, moment.time));
    } else if (!by_angle) {
      sun_azimuth_deg_ = kSomeSunAzimuth_deg;
      set("/sun/azimuth_deg", kSomeSunAzimuth_deg);
      set("/sun/elevation_deg", kMorningSun_deg);
    }
  }

  /// Returns the side of the area of the files around the middle in metres.
  double extent() const {
    if (scene_.terrain.extent_m) return *scene_.terrain.extent_m;
    return std::max({land_->size_m().x, land_->size_m().y, 20.0 * land_->cell_m()});
  }

  /// Returns the best views, at least one. Their places count from `around_`.
  std::vector<ViewChoice> find_views(int count) {
    double extent_m = std::min(extent(), kMostGround_m * 8.0);
    around_ = middle_;
    if (extent_m > kMostExtent_m && !gives("/terrain/place")) {
      const ViewMap coarse(*land_, around_, extent_m, has_sea_);
      const auto best = choose_views(coarse, sun_azimuth_deg_, 1);
      if (!best.empty()) around_ = point_at(around_, best[0].place);
      extent_m = kNearExtent_m;
    }
    const ViewMap map(*land_, around_, std::min(extent_m, kMostExtent_m), has_sea_);
    ViewPlaces places;
    if (gives_balloon() && !anchored_) {
      places = {{scene_.balloon.position.x, scene_.balloon.position.z}};
    } else if (anchored_ || gives("/terrain/place")) {
      places = {dvec2(0.0)};
    }
    auto views = choose_views(map, sun_azimuth_deg_, count, places);
    if (views.empty()) views.push_back({.above_ground_m = kUsualHeight_m});
    return views;
  }

  land::LandPoint point_at(const land::LandPoint& from, const dvec2& way) const {
    if (!from.place) return {std::nullopt, from.own + dvec2(way.x, -way.y)};
    return {geo::place_of_local(*from.place, way), {}};
  }

  /// Sets place, balloon and camera to a view.
  void apply(const ViewChoice& view) {
    if (!gives("/terrain/place") && !anchored_) {
      middle_ = point_at(around_, gives_balloon() ? dvec2(0.0) : view.place);
      if (middle_.place) {
        set("/terrain/place/latitude_deg", middle_.place->latitude_deg);
        set("/terrain/place/longitude_deg", middle_.place->longitude_deg);
      } else {
        set("/terrain/place/easting", middle_.own.x);
        set("/terrain/place/northing", middle_.own.y);
      }
    }
    if (!gives_balloon()) set("/balloon/position", list_of({0.0, view.above_ground_m, 0.0}));
    set("/balloon/heading_deg",
        view.azimuth_deg > 180.0 ? view.azimuth_deg - 360.0 : view.azimuth_deg);
    notes_.push_back(fmt::format(
        "No camera is given; it looks to azimuth {:.0f} degrees, {:.0f} m above the ground{}.",
        view.azimuth_deg, view.above_ground_m, place_text()));
    if (scene_.camera.view == scene::View::basket) return;
    const double size = scene_.balloon.diameter_m / 18.8;
    // The balloon stands on the side of the picture where the skyline is lower.
    const double turn = view.peak_turn_deg > 0.0 ? -kBalloonTurn_deg : kBalloonTurn_deg;
    const dvec2 floor = gives("/balloon/position")
                            ? dvec2(scene_.balloon.position.x, scene_.balloon.position.z)
                            : dvec2(0.0);
    const dvec3 stand =
        dvec3(floor.x, 2.0, floor.y) - kStand_m * size * towards(view.azimuth_deg + turn);
    const dvec3 look = stand + 1000.0 * towards(view.azimuth_deg) -
                       dvec3(0.0, 1000.0 * std::tan(glm::radians(kDip_deg)), 0.0);
    set("/camera/height_above", "balloon");
    set("/camera/position", list_of(stand));
    set("/camera/target", list_of(look));
  }

  std::string place_text() const {
    if (!middle_.place) {
      return fmt::format(" at ({:.0f}, {:.0f})", middle_.own.x, middle_.own.y);
    }
    const geo::Place& at = *middle_.place;
    return fmt::format(" at {:.4f} {}, {:.4f} {}", std::abs(at.latitude_deg),
                       at.latitude_deg < 0.0 ? "S" : "N", std::abs(at.longitude_deg),
                       at.longitude_deg < 0.0 ? "W" : "E");
  }

  /// Chooses what follows from the view, and returns the scene.
  Staged finished() {
    choose_size();
    choose_biome();
    return {source_.with(changes_), std::move(notes_), std::move(changes_), land_};
  }

  /// Adds what was guessed about the land cover and the picture over the land, which does not
  /// depend on the view.
  void add_overlay_notes(Staged& staged) const {
    const auto add = [&staged](const auto& overlay) {
      if (!overlay) return;
      staged.notes.insert(staged.notes.end(), overlay->notes().begin(), overlay->notes().end());
    };
    add(terrain::cover_of(staged.source.scene().terrain, reliefs_));
    add(terrain::drape_of(staged.source.scene().terrain, reliefs_));
  }

  void choose_size() {
    if (gives("/terrain/size_m")) return;
    const double most = std::min(2.0 * extent(), kMostGround_m);
    set("/terrain/size_m", std::round(std::clamp(most, kLeastGround_m, kMostGround_m)));
  }

  void choose_biome() {
    set("/biome/water/enabled", has_sea_ ? "true" : "false");
    const double highest = land_->highest_m();
    const double top = scene_.sky.cumulus.base_m;
    set("/sky/cumulus/base_m", std::round(std::max(top, 0.75 * highest + 900.0)));
    if (gives("/biome/kind")) return;
    const Climate climate = climate_of(middle_.place.value_or(kSomePlace), month_,
                                       std::max<double>(land_->lowest_m(), 0.0), highest);
    for (const Override& change : biome_values(climate, has_sea_))
      set(change.pointer, change.value);
    notes_.push_back(fmt::format(
        "No biome is given; it is {} with snow above {:.0f} m and trees up to {:.0f} m, by {}, "
        "height and season.",
        scene::detail::word_of(climate.biome), climate.snow_line_m, climate.tree_line_m,
        middle_.place ? "latitude" : "46 degrees of latitude, because the place is unknown"));
  }

  const scene::SceneSource& source_;
  const scene::Scene& scene_;
  terrain::ReliefCache& reliefs_;
  std::shared_ptr<const land::Land> land_;
  land::LandPoint middle_;
  land::LandPoint around_;
  std::optional<FlightPoint> flight_;
  bool anchored_ = false;  // the middle of the ground is a place that the scene gives for something
  bool has_sea_ = false;
  double sun_azimuth_deg_ = 0.0, month_ = 9.4;
  std::vector<Override> changes_;
  std::vector<std::string> notes_;
};

}  // namespace

Staged stage(const scene::SceneSource& source, terrain::ReliefCache& reliefs, int view) {
  return stage_views(source, reliefs, view + 1).back();
}

std::vector<Staged> stage_views(const scene::SceneSource& source, terrain::ReliefCache& reliefs,
                                int count) {
  if (source.scene().terrain.kind != scene::TerrainKind::elevation) return {{source, {}}};
  return Stage(source, reliefs).run(count);
}

scene::SceneSource scene_around(const std::filesystem::path& file) {
  return scene::SceneSource().with(
      {{"/terrain/source", std::filesystem::absolute(file).lexically_normal().string()}});
}

std::shared_ptr<const land::Land> land_of(const std::filesystem::path& file) {
  terrain::RealLandCache lands;
  return terrain::real_land(scene_around(file).scene().terrain, lands);
}

}  // namespace aerostat::staging
