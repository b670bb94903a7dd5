#include "scene/semantics.hpp"

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "scene/enum_names.hpp"
#include "scene/film_semantics.hpp"
#include "scene/sun_position.hpp"

namespace aerostat::scene::detail {

namespace {

bool is_null(const dvec3& v) {
  return v.x == 0.0 && v.y == 0.0 && v.z == 0.0;
}

void check_direction(const Json& sun, Faults& faults) {
  const auto direction = sun.find("direction");
  if (direction == sun.end()) return;
  for (const char* angle : {"azimuth_deg", "elevation_deg"}) {
    if (!sun.contains(angle)) continue;
    faults.add({"sun", angle}, "an angle beside /sun/direction", "either the direction or angles");
  }
  if (is_null({(*direction)[0], (*direction)[1], (*direction)[2]})) {
    faults.add({"sun", "direction"}, describe(*direction), "a vector that is not null");
  }
}

void check_day_and_time(const std::string& date, const std::string& time, Faults& faults) {
  const std::string midnight = "00:00", new_year = "2000-01-01";
  if (!days_from_2000(date, midnight)) {
    faults.add({"sun", "date"}, describe(date),
               "a day of the years 1900 to 2100 such as \"2024-06-21\"");
  }
  if (!days_from_2000(new_year, time)) {
    faults.add({"sun", "time"}, describe(time),
               "a time of day such as \"06:30\", \"06:30:15Z\" or \"06:30+02:00\"");
  }
}

/// Checks that date, time and place are given together, and that no direction is given beside
/// them.
void check_date(const Json& sun, Faults& faults) {
  const bool dated = std::any_of(std::begin(kSunDateKeys), std::end(kSunDateKeys),
                                 [&sun](const char* key) { return sun.contains(key); });
  if (!dated) return;
  for (const char* key : {"direction", "azimuth_deg", "elevation_deg"}) {
    if (!sun.contains(key)) continue;
    faults.add({"sun", key}, "a direction beside date, time and place",
               "either the one or the other");
  }
  for (const char* key : kSunDateKeys) {
    if (sun.contains(key)) continue;
    faults.add({"sun", key}, "nothing",
               "date, time, latitude_deg and longitude_deg, which belong together");
  }
  if (sun.contains("date") && sun.contains("time")) {
    check_day_and_time(sun["date"], sun["time"], faults);
  }
}

void check_camera(const Camera& camera, const std::string& name) {
  if (is_null(camera.up)) {
    fail(name, {"camera", "up"}, "[0, 0, 0]", "a vector that is not null");
  }
  if (camera.target && camera.target == camera.position) {
    fail(name, {"camera", "target"}, "the camera's own position", "another point");
  }
}

void check_order(const double (&range)[2], const char* key, const std::string& name) {
  if (range[0] <= range[1]) return;
  fail(name, {"biome", "ground", key}, fmt::format("[{}, {}]", range[0], range[1]),
       "the smaller one first");
}

void check_balloons(const Scene& scene, const std::string& name) {
  const int listed = static_cast<int>(scene.balloons.size());
  if (listed + scene.festival.count <= kMostFurtherBalloons) return;
  fail(name, {"festival", "count"}, fmt::format("{}", scene.festival.count),
       fmt::format("at most {} beside the {} of /balloons, {} together",
                   kMostFurtherBalloons - listed, listed, kMostFurtherBalloons));
}

/// Checks that each light has a place.
void check_lights(const Json& document, Faults& faults) {
  const auto lights = document.find("lights");
  if (lights == document.end()) return;
  for (std::size_t i = 0; i < lights->size(); ++i) {
    if ((*lights)[i].contains("position") || (*lights)[i].contains("at")) continue;
    faults.add({"lights", std::to_string(i), "position"}, "nothing",
               "a position in metres, or a place on the Earth in at");
  }
}

void check_artwork(const Artwork& artwork, const Pointer& pointer, const std::string& name) {
  const auto fail_at = [&](const char* key, const std::string& found, const std::string& expected) {
    Pointer at = pointer;
    at.emplace_back(key);
    fail(name, at, found, expected);
  };
  if (artwork.file.empty()) fail_at("file", "an empty name", "the name of a file");
  const std::string wrap = word_of(artwork.wrap);
  const auto belongs = [&](const char* key, bool given, ArtworkWrap to) {
    if (!given || artwork.wrap == to) return;
    fail_at(key, fmt::format("a value beside the wrap \"{}\"", wrap),
            fmt::format("the wrap \"{}\", or no {}", word_of(to), key));
  };
  belongs("height_m", artwork.height_m.has_value(), ArtworkWrap::motif);
  belongs("width_m", artwork.width_m.has_value(), ArtworkWrap::motif);
  belongs("heights_m", artwork.heights_m.has_value(), ArtworkWrap::band);
  if (artwork.wrap == ArtworkWrap::gores && artwork.repeat) {
    fail_at("repeat", "copies of a picture of all gores", "another wrap, or no repeat");
  }
  if (artwork.heights_m && !(artwork.heights_m->x < artwork.heights_m->y)) {
    fail_at("heights_m", fmt::format("[{}, {}]", artwork.heights_m->x, artwork.heights_m->y),
            "the lower height, and a greater one");
  }
}

/// Checks an envelope of a special shape.
void check_envelope(const Balloon& balloon, Pointer pointer, const std::string& name) {
  if (!balloon.artwork.empty()) {
    pointer.emplace_back("artwork");
    fail(name, pointer, "artwork on an envelope of a special shape",
         "textures in its file, or a usual envelope");
  }
  if (!balloon.envelope->file.empty()) return;
  pointer.insert(pointer.end(), {"envelope", "file"});
  fail(name, pointer, "an empty name", "the name of a file");
}

/// Checks the pictures on all envelopes.
void check_artworks(const Scene& scene, const std::string& name) {
  const auto check = [&name](const Balloon& balloon, const Pointer& of_balloon) {
    if (balloon.envelope) check_envelope(balloon, of_balloon, name);
    for (std::size_t i = 0; i < balloon.artwork.size(); ++i) {
      Pointer pointer = of_balloon;
      pointer.insert(pointer.end(), {"artwork", std::to_string(i)});
      check_artwork(balloon.artwork[i], pointer, name);
    }
  };
  check(scene.balloon, {"balloon"});
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    check(scene.balloons[i], {"balloons", std::to_string(i)});
  }
}

/// Checks that a range begins with the lesser number.
void check_range(Pointer pointer, const char* key, const dvec2& range, const std::string& name) {
  if (range.x <= range.y) return;
  pointer.emplace_back(key);
  fail(name, pointer, fmt::format("[{}, {}]", range.x, range.y), "the smaller one first");
}

void check_area(const PlacedArea& area, const std::string& index, const std::string& name) {
  const Pointer at{"objects", index, "area"};
  check_range(at, "slope_deg", area.slope_deg, name);
  check_range(at, "heights_m", area.heights_m, name);
  check_range(at, "sizes", area.sizes, name);
}

/// Checks the ranges of each species from a file, and that it has a file.
void check_species(const Scene& scene, const std::string& name) {
  const auto& species = scene.vegetation.species;
  for (std::size_t i = 0; i < species.size(); ++i) {
    const Pointer at{"vegetation", "species", std::to_string(i)};
    check_range(at, "slope_deg", species[i].slope_deg, name);
    check_range(at, "heights_m", species[i].heights_m, name);
    if (species[i].height_m) check_range(at, "height_m", *species[i].height_m, name);
    if (!species[i].file.empty()) continue;
    fail(name, {"vegetation", "species", std::to_string(i), "file"}, "an empty name",
         "the name of a file");
  }
}

/// Checks that each model has a file, and that there are not too many instances.
void check_objects(const Scene& scene, const std::string& name) {
  std::int64_t instances = 0;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const PlacedModel& placed = scene.objects[i];
    if (placed.area) check_area(*placed.area, std::to_string(i), name);
    instances += placed.count;
    if (instances > kMostInstances) {
      fail(name, {"objects", std::to_string(i), "count"},
           fmt::format("{} instances with those before", instances),
           fmt::format("at most {} in all", kMostInstances));
    }
    if (!scene.objects[i].file.empty()) continue;
    fail(name, {"objects", std::to_string(i), "file"}, "an empty name", "the name of a file");
  }
}

void check_source(const Terrain& terrain, const std::string& name) {
  const bool is_elevation = terrain.kind == TerrainKind::elevation;
  if (is_elevation && terrain.source.empty()) {
    fail(name, {"terrain", "kind"}, "\"elevation\" without a source",
         "a file of elevation data in /terrain/source");
  }
  if (!is_elevation && !terrain.source.empty()) {
    fail(name, {"terrain", "kind"}, "a kind of ground that is made from noise beside a source",
         "\"elevation\", or no /terrain/source");
  }
  for (const std::string& file : terrain.source) {
    if (file.empty()) fail(name, {"terrain", "source"}, "an empty name", "the name of a file");
  }
}

/// Checks that places on the Earth are only given where the land has them.
void check_geo_points(const Scene& scene, const std::string& name) {
  if (scene.terrain.kind == TerrainKind::elevation) return;
  const auto refuse = [&name](bool given, Pointer pointer) {
    if (!given) return;
    fail(name, std::move(pointer), "a place on the Earth in a landscape that is made from noise",
         "positions in metres, or elevation data in /terrain/source");
  };
  refuse(scene.camera.at.has_value(), {"camera", "at"});
  refuse(scene.camera.look_at.has_value(), {"camera", "look_at"});
  refuse(scene.balloon.at.has_value(), {"balloon", "at"});
  refuse(scene.balloon.track.has_value(), {"balloon", "track"});
  for (std::size_t i = 0; i < scene.balloons.size(); ++i) {
    refuse(scene.balloons[i].at.has_value(), {"balloons", std::to_string(i), "at"});
    refuse(scene.balloons[i].track.has_value(), {"balloons", std::to_string(i), "track"});
  }
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    refuse(scene.lights[i].at.has_value(), {"lights", std::to_string(i), "at"});
  }
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    refuse(scene.objects[i].at.has_value(), {"objects", std::to_string(i), "at"});
  }
}

void check_terrain_place(const Terrain& terrain, const std::string& name) {
  const TerrainPlace& place = terrain.place;
  const Pointer pointer = {"terrain", "place"};
  if (place.latitude_deg.has_value() != place.longitude_deg.has_value()) {
    fail(name, pointer, "one of latitude_deg and longitude_deg", "both of them");
  }
  if (place.easting.has_value() != place.northing.has_value()) {
    fail(name, pointer, "one of easting and northing", "both of them");
  }
  if (place.latitude_deg && place.easting) {
    fail(name, pointer, "latitude_deg and easting", "either degrees or the source's coordinates");
  }
  const std::optional<dvec2>& ends = terrain.image_heights_m;
  if (ends && ends->x >= ends->y) {
    fail(name, {"terrain", "image_heights_m"}, fmt::format("[{}, {}]", ends->x, ends->y),
         "the height of black, and a greater one of white");
  }
}

void check_drape(const Terrain& terrain, const std::string& name) {
  const DrapeCorners& corners = terrain.drape.corners;
  const Pointer pointer = {"terrain", "drape", "corners"};
  if (!terrain.drape.file.empty() && terrain.source.empty()) {
    fail(name, {"terrain", "drape", "file"}, "a picture on ground that is made from noise",
         "a file of elevation data in /terrain/source, or no picture");
  }
  if (corners.north_west.has_value() != corners.south_east.has_value()) {
    fail(name, pointer, "one of north_west and south_east", "both of them");
  }
  if (!corners.north_west) return;
  const dvec2 &from = *corners.north_west, &to = *corners.south_east;
  if (!(from.x <= 90.0 && to.x >= -90.0 && from.x > to.x)) {
    fail(name, pointer, fmt::format("latitudes {} and {}", from.x, to.x),
         "latitudes of -90 to 90, that of north_west the greater one");
  }
  if (from.y == to.y) {
    fail(name, pointer, fmt::format("longitude {} twice", to.y),
         "a picture that is some degrees wide");
  }
}

void check_cover(const Terrain& terrain, const std::string& name) {
  if (!terrain.cover.source.empty() && terrain.source.empty()) {
    fail(name, {"terrain", "cover", "source"}, "land cover on ground that is made from noise",
         "a file of elevation data in /terrain/source, or no land cover");
  }
}

}  // namespace

void check_semantics(const Json& document, const Scene& scene, Faults& faults) {
  const std::string& name = faults.name();
  const auto sun = document.find("sun");
  if (sun != document.end()) {
    check_date(*sun, faults);
    check_direction(*sun, faults);
  }
  check_lights(document, faults);
  faults.gather([&] { check_camera(scene.camera, name); });
  faults.gather([&] { check_balloons(scene, name); });
  faults.gather([&] { check_artworks(scene, name); });
  faults.gather([&] { check_objects(scene, name); });
  faults.gather([&] { check_species(scene, name); });
  faults.gather([&] { check_source(scene.terrain, name); });
  faults.gather([&] { check_geo_points(scene, name); });
  faults.gather([&] { check_terrain_place(scene.terrain, name); });
  faults.gather([&] { check_drape(scene.terrain, name); });
  faults.gather([&] { check_cover(scene.terrain, name); });
  faults.gather([&] { check_film(scene.film, name); });
  const Ground& ground = scene.biome.ground;
  faults.gather([&] { check_order(ground.rock_slope_deg, "rock_slope_deg", name); });
  faults.gather([&] { check_order(ground.snow_slope_deg, "snow_slope_deg", name); });
}

}  // namespace aerostat::scene::detail
