#include <exception>
#include <fstream>
#include <functional>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/io.hpp"
#include "scene/scene.hpp"

namespace aerostat::scene {
namespace {

using nlohmann::json;

json schema() {
  std::ifstream file(AEROSTAT_SOURCE_DIR "/scenes/aerostat-scene.schema.json");
  return json::parse(file);
}

const json& follow(const json& rule, const json& root) {
  if (rule.contains("$ref")) {
    return root.at(json::json_pointer(rule["$ref"].get<std::string>().substr(1)));
  }
  return rule.contains("anyOf") ? rule["anyOf"].back() : rule;
}

/// Calls `visit` with the path and the rule of every field.
void walk(const json& rule, const json& root, const std::string& path,
          const std::function<void(const std::string&, const json&)>& visit) {
  const json& resolved = follow(rule, root);
  visit(path, resolved);
  if (resolved.contains("properties")) {
    for (const auto& [key, child] : resolved["properties"].items()) {
      walk(child, root, path + "/" + key, visit);
    }
  }
  if (resolved.contains("items") && follow(resolved["items"], root)["type"] == "object") {
    walk(resolved["items"], root, path + "/0", visit);
  }
}

Scene full_scene() {
  Scene scene = defaults(BiomeKind::snow, View::outside);
  scene.lights.emplace_back().at = GeoPoint{};
  scene.balloon.at = scene.camera.at = scene.camera.look_at = GeoPoint{};
  scene.balloon.track = FlightTrack{"flight.igc", "", 0.5, 0, "", 1.0, TrackLine{}};
  Artwork& artwork = scene.balloon.artwork.emplace_back();
  artwork.height_m = artwork.width_m = 5.0;
  artwork.heights_m = dvec2(1.0, 2.0);
  artwork.repeat = 2;
  scene.balloon.envelope = EnvelopeModel{"a.glb", UpAxis::y, 20.0, 0.0};
  scene.balloons.push_back(scene.balloon);
  scene.image.exposure_ev = 0.0;
  scene.image.white_balance_k = 6504.0;
  scene.camera.aperture_m = 0.0;
  scene.camera.focus_m = 10.0;
  scene.sky.radiance = vec3(1.0f);
  scene.terrain.source = {"davos.tif"};
  scene.terrain.nodata = -9999.0;
  scene.terrain.image_heights_m = dvec2(0.0, 1000.0);
  scene.terrain.cell_m = 30.0;
  scene.terrain.extent_m = 20000.0;
  scene.terrain.cover.classes.emplace_back();
  scene.terrain.place = {46.8, 9.8, 2600000.0, 1200000.0};
  scene.objects.push_back({.file = "a.glb", .at = GeoPoint{}, .height_m = 2.0});
  scene.objects.back().area = PlacedArea{};
  scene.vegetation.clearings.emplace_back();
  scene.vegetation.species.push_back({.file = "b.glb", .height_m = dvec2(3.0, 4.0)});
  scene.terrain.drape.corners = {dvec2(46.9, 9.7), dvec2(46.7, 9.9)};
  scene.film.keys = {{"/image/spp", Easing::smooth, {{1.0, {{4.0}, false, ""}}}}};
  scene.film.camera.path.resize(1);
  return scene;
}

TEST(SceneSchema, DescribesAndBoundsEveryField) {
  const json root = schema();
  EXPECT_EQ(root["$schema"], "http://json-schema.org/draft-07/schema#");
  walk(root, root, "", [](const std::string& path, const json& rule) {
    EXPECT_TRUE(rule.contains("description")) << path;
    const std::string type = rule.at("type");
    EXPECT_EQ(rule.value("additionalProperties", true), type != "object") << path;
    const bool number = type == "number" || type == "integer";
    if (number && !rule.contains("enum")) {
      EXPECT_TRUE(rule.contains("minimum") || rule.contains("exclusiveMinimum")) << path;
      EXPECT_TRUE(rule.contains("maximum")) << path;
    }
    EXPECT_EQ(rule.contains("maxItems"), type == "array") << path;
  });
}

TEST(SceneSchema, KnowsExactlyTheKeysThatAreWritten) {
  const json root = schema();
  std::set<std::string> known;
  walk(root, root, "", [&known](const std::string& path, const json& rule) {
    if (rule["type"] != "object") known.insert(path);
  });
  std::set<std::string> written;
  const json dump = json::parse(write_text(full_scene()));
  const std::function<void(const json&, const std::string&)> collect =
      [&](const json& node, const std::string& path) {
        const bool objects = node.is_array() && !node.empty() && node[0].is_object();
        if (!node.is_object()) written.insert(path);
        if (!node.is_object() && !objects) return;
        for (const auto& [key, child] : node.items()) collect(child, path + "/" + key);
      };
  collect(dump, "");
  for (const char* only_read : {"/$schema", "/sun/azimuth_deg", "/sun/elevation_deg", "/sun/date",
                                "/sun/time", "/sun/latitude_deg", "/sun/longitude_deg"}) {
    EXPECT_EQ(known.erase(only_read), 1u) << only_read;
  }
  EXPECT_EQ(known, written);
}

/// A film in which every list of objects has some.
constexpr const char* kFilm = R"({"version": 1, "film": {
    "keys": [{"value": "/image/spp", "keys": [{"time_s": 0, "is": 1}]}],
    "camera": {"path": [{"position": [0, 0, 0]}, {"position": [1, 0, 0]}]}}})";
/// A film with one key and one point, so that their times are free.
constexpr const char* kShortFilm = R"({"version": 1, "film": {
    "keys": [{"value": "/image/spp", "keys": [{"time_s": 0, "is": 1}]}],
    "camera": {"path": [{"position": [0, 0, 0]}]}}})";

/// Balloons with an envelope of a special shape each.
constexpr const char* kEnvelope = R"({"version": 1, "balloon": {"envelope": {"file": "a.glb"}},
    "balloons": [{"envelope": {"file": "a.glb"}}]})";

bool is_of_envelope(const std::string& path) {
  return path.find("/envelope/") != std::string::npos && path.starts_with("/balloon");
}

/// Balloons with a motif each.
constexpr const char* kArtwork = R"({"version": 1,
    "balloon": {"artwork": [{"file": "a.png", "wrap": "motif"}]},
    "balloons": [{"artwork": [{"file": "a.png", "wrap": "motif"}]}]})";

/// A model, a species of plants and a clearing.
constexpr const char* kModels = R"({"version": 1, "objects": [{"file": "a.obj"}],
    "vegetation": {"species": [{"file": "a.obj"}], "clearings": [{"center": [0, 0]}]}})";

bool is_of_models(const std::string& path) {
  return path.starts_with("/objects/") || path.starts_with("/vegetation/");
}

bool is_of_artwork(const std::string& path) {
  return path.find("/artwork/") != std::string::npos;
}

TEST(SceneSchema, AcceptsEveryWordThatItNames) {
  const json root = schema();
  int words = 0;
  walk(root, root, "", [&words](const std::string& path, const json& rule) {
    for (const json& word : rule.value("enum", json::array())) {
      const bool needs_source = path == "/terrain/kind" && word == "elevation";
      const std::string text = path.starts_with("/film/") ? kFilm
                               : needs_source ? R"({"version": 1, "terrain": {"source": "a.tif"}})"
                               : is_of_artwork(path)  ? kArtwork
                               : is_of_envelope(path) ? kEnvelope
                               : is_of_models(path)   ? kModels
                               : path.starts_with("/lights/")
                                   ? R"({"version": 1, "lights": [{"position": [0, 0, 0]}]})"
                                   : R"({"version": 1})";
      const Scene scene = read_text(text, "x.json", {{path, word.dump()}});
      const json dump = json::parse(write_text(scene));
      // A biome that is left open becomes the first one.
      const json expected = path == "/biome/kind" && word == kLeftOutBiome ? json("snow") : word;
      EXPECT_EQ(dump.at(json::json_pointer(path)), expected) << path;
      ++words;
    }
  });
  EXPECT_GT(words, 25);
}

TEST(SceneSchema, BoundsAreEnforcedAtBothEnds) {
  const json root = schema();
  walk(root, root, "", [](const std::string& path, const json& rule) {
    if (rule.contains("enum")) return;
    if (rule["type"] != "number" && rule["type"] != "integer") return;
    std::string text = R"({"version": 1})";
    // Some fields need others beside them.
    if (path.starts_with("/film/")) text = kShortFilm;
    if (path == "/sun/latitude_deg" || path == "/sun/longitude_deg") {
      text = R"({"version": 1, "sun": {"date": "2024-06-21", "time": "06:30", "latitude_deg": 0,
                 "longitude_deg": 0}})";
    }
    if (path == "/terrain/place/latitude_deg" || path == "/terrain/place/longitude_deg") {
      text = R"({"version": 1, "terrain": {"place": {"latitude_deg": 0, "longitude_deg": 0}}})";
    }
    if (path == "/terrain/place/easting" || path == "/terrain/place/northing") {
      text = R"({"version": 1, "terrain": {"place": {"easting": 0, "northing": 0}}})";
    }
    if (is_of_artwork(path)) text = kArtwork;
    if (is_of_envelope(path)) text = kEnvelope;
    if (path.starts_with("/lights/")) {
      text = R"({"version": 1, "lights": [{"position": [0, 0, 0]}]})";
    }
    if (is_of_models(path)) text = kModels;
    if (path.find("at/") != std::string::npos || path.find("/track/") != std::string::npos) {
      text = R"({"version": 1, "terrain": {"source": "a.tif"},
                 "balloon": {"at": {"latitude_deg": 0, "longitude_deg": 0}, "track": {"file": "a.igc"}},
                 "balloons": [{"at": {"latitude_deg": 0, "longitude_deg": 0},
                               "track": {"file": "a.igc"}}],
                 "lights": [{"at": {"latitude_deg": 0, "longitude_deg": 0}}],
                 "objects": [{"file": "a.obj", "at": {"latitude_deg": 0, "longitude_deg": 0}}],
                 "camera": {"at": {"latitude_deg": 0, "longitude_deg": 0},
                            "look_at": {"latitude_deg": 0, "longitude_deg": 0}}})";
    }
    const auto accepts = [&](double value) {
      try {
        read_text(text, "x.json", {{path, json(value).dump()}});
        return true;
      } catch (const std::exception&) {
        return false;
      }
    };
    const bool open = rule.contains("exclusiveMinimum");
    const double least = open ? rule["exclusiveMinimum"] : rule["minimum"];
    EXPECT_EQ(accepts(least), !open) << path;
    EXPECT_TRUE(accepts(rule["maximum"])) << path;
    EXPECT_FALSE(accepts(least - 1.0)) << path;
    EXPECT_FALSE(accepts(rule["maximum"].get<double>() + 1.0)) << path;
  });
}

}  // namespace
}  // namespace aerostat::scene
