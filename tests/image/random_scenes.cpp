#include "random_scenes.hpp"

#include <algorithm>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <limits>
#include <random>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "scene/io.hpp"
#include "scene/schema.hpp"

namespace aerostat::test {
namespace {

using scene::detail::Json;

struct Range {
  double least, most;
};

/// Returns the range of a number's rule. A bound that is excluded is one step of a double outside
/// the range.
Range range_of(const Json& rule) {
  const double inf = std::numeric_limits<double>::infinity();
  Range range{-inf, inf};
  if (rule.contains("minimum")) range.least = rule["minimum"];
  if (rule.contains("maximum")) range.most = rule["maximum"];
  if (rule.contains("exclusiveMinimum"))
    range.least = std::nextafter(rule["exclusiveMinimum"].get<double>(), inf);
  if (rule.contains("exclusiveMaximum"))
    range.most = std::nextafter(rule["exclusiveMaximum"].get<double>(), -inf);
  return range;
}

class Maker {
 public:
  explicit Maker(std::uint32_t seed)
      : random_(seed), share_(pick(std::vector<double>{0.02, 0.05, 0.1, 0.3, 1.0})) {}

  Json document() {
    Json made = object(scene::detail::schema_document());
    made["version"] = 1;
    settle_sun(made);
    settle_order(made);
    settle_terrain(made);
    // The lists of a film hang together, and a picture does not show them.
    made.erase("film");
    return made;
  }

 private:
  template <typename T>
  T pick(const std::vector<T>& from) {
    return from[std::uniform_int_distribution<std::size_t>(0, from.size() - 1)(random_)];
  }
  bool chance(double share) { return std::bernoulli_distribution(share)(random_); }
  double between(double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random_);
  }

  Json value(const Json& rule, const std::string& key) {
    if (rule.contains("$ref")) {
      const auto at = Json::json_pointer(rule["$ref"].get<std::string>().substr(1));
      return value(scene::detail::schema_document().at(at), key);
    }
    if (rule.contains("anyOf")) {
      return value(pick(rule["anyOf"].get<std::vector<Json>>()), key);
    }
    if (rule.contains("const")) return rule["const"];
    if (rule.contains("enum")) return pick(rule["enum"].get<std::vector<Json>>());
    const std::string type = rule.at("type");
    if (type == "object") return object(rule);
    if (type == "array") return array(rule, key);
    if (type == "boolean") return chance(0.5);
    if (type == "string") return words(key);
    return type == "integer" ? integer(range_of(rule)) : Json(number(range_of(rule)));
  }

  /// Returns an object in which each key appears at random. An object that appears has at least one
  /// key.
  Json object(const Json& rule) {
    Json made = Json::object();
    const Json& properties = rule.at("properties");
    for (const auto& [key, child] : properties.items()) {
      const bool holds_others = child.contains("properties") || child.contains("$ref");
      const double share = holds_others ? std::min(1.0, 4.0 * share_) : share_;
      if (key != "$schema" && key != "version" && chance(share)) made[key] = value(child, key);
    }
    return made;
  }

  Json array(const Json& rule, const std::string& key) {
    const std::size_t least = rule.value("minItems", 0), most = rule.at("maxItems");
    const std::size_t few = std::min<std::size_t>(most, least + 3);
    const std::size_t count =
        std::uniform_int_distribution<std::size_t>(least, chance(0.05) ? most : few)(random_);
    Json made = Json::array();
    for (std::size_t i = 0; i < count; ++i) made.push_back(value(rule.at("items"), key));
    return made;
  }

  Json integer(const Range& range) {
    const auto least = static_cast<std::int64_t>(range.least);
    const auto most = static_cast<std::int64_t>(range.most);
    switch (whole(0, 5)) {
      case 0:
        return least;
      case 1:
        return most;
      case 2:
        return std::min(least + 1, most);
      case 3:
        return std::max(most - 1, least);
      case 4:
        return static_cast<std::int64_t>(std::clamp(
            std::exp2(between(0.0, 32.0)), static_cast<double>(least), static_cast<double>(most)));
      default:
        return std::uniform_int_distribution<std::int64_t>(least, most)(random_);
    }
  }

  double number(const Range& range) {
    const double inf = std::numeric_limits<double>::infinity();
    double made = 0.0;
    switch (whole(0, 9)) {
      case 0:
        return range.least;
      case 1:
        return range.most;
      case 2:
        return std::nextafter(range.least, inf);
      case 3:
        return std::nextafter(range.most, -inf);
      case 4:
        // The number is zero, or next to zero.
        break;
      case 5:
      case 6:
        made = std::pow(10.0, between(-12.0, std::log10(std::max(range.most, 1.0))));
        if (chance(0.5)) made = -made;
        break;
      case 7:
        made = std::round(between(range.least, range.most));
        break;
      default:
        made = between(range.least, range.most);
    }
    return std::clamp(made, range.least, range.most);
  }

  int whole(int least, int most) {
    return std::uniform_int_distribution<int>(least, most)(random_);
  }

  std::string words(const std::string& key) {
    if (key == "time") {
      const auto zone = pick<std::string>({"", "Z", "+02:00"});
      return fmt::format("{:02}:{:02}{}", whole(0, 23), whole(0, 59), zone);
    }
    return fmt::format("{}-{:02}-{:02}", whole(1900, 2100), whole(1, 12), whole(1, 28));
  }

  /// Makes the ground from noise, because no file of elevation data is at hand. Then there are no
  /// places on the Earth.
  static void settle_terrain(Json& made) {
    const auto settle = [](Json& object) {
      for (const char* key : {"at", "look_at", "track", "artwork", "envelope"}) object.erase(key);
    };
    for (const char* key : {"camera", "balloon"}) {
      if (made.contains(key)) settle(made[key]);
    }
    for (Json& balloon : made["balloons"]) settle(balloon);
    if (made["balloons"].is_null()) made.erase("balloons");
    // A light that has no place on the Earth needs a position.
    for (Json& light : made["lights"]) {
      settle(light);
      if (!light.contains("position")) light["position"] = Json::array({0.0, 500.0, 0.0});
    }
    if (made["lights"].is_null()) made.erase("lights");
    made.erase("objects");
    if (made.contains("vegetation")) made["vegetation"].erase("species");
    if (!made.contains("terrain")) return;
    Json& terrain = made["terrain"];
    for (const char* key : {"source", "place", "image_heights_m", "drape", "cover"})
      terrain.erase(key);
    if (terrain.value("kind", "") == "elevation") terrain.erase("kind");
  }

  /// Makes the place of the sun follow from a direction, from angles or from a date, but never from
  /// two of them.
  void settle_sun(Json& made) {
    if (!made.contains("sun")) return;
    Json& sun = made["sun"];
    const std::vector<std::string> date{"date", "time", "latitude_deg", "longitude_deg"};
    const Json& rules =
        scene::detail::schema_document().at("properties").at("sun").at("properties");
    const bool dated = std::any_of(date.begin(), date.end(),
                                   [&](const std::string& key) { return sun.contains(key); });
    const bool by_date = dated && chance(0.5);
    for (const std::string& key : date) {
      sun.erase(key);
      if (by_date) sun[key] = value(rules.at(key), key);
    }
    if (by_date || sun.contains("direction")) {
      sun.erase("azimuth_deg");
      sun.erase("elevation_deg");
    }
    if (by_date) sun.erase("direction");
  }

  void settle_order(Json& made) {
    if (!made.contains("biome") || !made["biome"].is_object()) return;
    Json& ground = made["biome"]["ground"];
    for (const char* key : {"rock_slope_deg", "snow_slope_deg"}) {
      if (ground.contains(key) && ground[key][0] > ground[key][1]) {
        std::swap(ground[key][0], ground[key][1]);
      }
    }
    if (ground.is_null()) made["biome"].erase("ground");
  }

  std::mt19937 random_;
  /// The share of the fields that are given.
  double share_;
};

/// A note about the scene that is being tested.
std::string note;

void tell_note(int signal) {
  [[maybe_unused]] const auto written = ::write(STDERR_FILENO, note.data(), note.size());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

const char* environment(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

}  // namespace

std::string random_scene(std::uint32_t seed) {
  return Maker(seed).document().dump(2) + "\n";
}

scene::Scene made_quick(scene::Scene scene) {
  scene.image.width = 16;
  scene.image.height = 9;
  scene.image.spp = 1;
  scene.terrain.cells = std::min(scene.terrain.cells, 48);
  scene.vegetation.reach_m = std::min(scene.vegetation.reach_m, 300.0);
  scene.vegetation.density = std::min(scene.vegetation.density, 0.3);
  return scene;
}

int random_scene_count(int usual) {
  const char* value = environment("AEROSTAT_RANDOM_SCENES");
  return value == nullptr ? usual : std::atoi(value);
}

std::uint32_t first_random_seed() {
  const char* value = environment("AEROSTAT_RANDOM_SEED");
  return value == nullptr ? 1u : static_cast<std::uint32_t>(std::strtoul(value, nullptr, 10));
}

CrashNote::CrashNote(std::uint32_t seed, const std::string& text) {
  note =
      fmt::format("\ncrashed at AEROSTAT_RANDOM_SEED={} AEROSTAT_RANDOM_SCENES=1:\n{}", seed, text);
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) std::signal(signal, tell_note);
}

CrashNote::~CrashNote() {
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS}) std::signal(signal, SIG_DFL);
}

}  // namespace aerostat::test
