#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "core/error.hpp"
#include "core/stop_scope.hpp"
#include "scatter/layer.hpp"

namespace aerostat::scatter {
namespace {

// The largest width over which candidates stray about the middles of their squares, in squares.
// Chosen by eye.
constexpr double kJitter = 0.9;

/// Makes separate random numbers for every square of the row with z number j.
class RowRandom {
 public:
  RowRandom(std::uint32_t seed, std::uint32_t layer, std::int64_t j) {
    plant::Random mixer((std::uint64_t{seed} << 32) ^ (layer * 0x9e3779b9u));
    const std::uint64_t row = mixer.bits() ^ (static_cast<std::uint64_t>(j) * 0xd1b54a32d192ed03u);
    bits_ = plant::Random(row).bits();
  }
  plant::Random square(std::int64_t i) const {
    return plant::Random(bits_ ^ (static_cast<std::uint64_t>(i) * 0x8cb92ba72f3d8dd7u));
  }

 private:
  std::uint64_t bits_;
};

/// Returns the share of candidates that stays at a distance from the centre.
double kept_at(double distance, double reach) {
  return std::clamp(2.0 - 2.0 * distance / reach, 0.0, 1.0);
}

class Planter {
 public:
  Planter(const Layer& layer, const Place& place, std::span<const plant::ModelKey> models)
      : layer_(layer), place_(place), models_(models), origin_(place.surface.origin()) {}

  /// Returns the instances in the row of squares with z number j.
  std::vector<Instance> plant_row(std::int64_t j) const {
    std::vector<Candidate> candidates = candidates_of_row(j);
    add_noise(candidates, &ground::GroundRule::fill_smooth);
    if (layer_.chance_at_most) {
      std::erase_if(candidates, [this](const Candidate& candidate) {
        return !(candidate.fate < static_cast<double>(layer_.chance_at_most(candidate.site)));
      });
    }
    add_noise(candidates, &ground::GroundRule::fill_rough);
    std::vector<Instance> row;
    for (Candidate& candidate : candidates) grow(candidate, row);
    return row;
  }

 private:
  /// A candidate that has passed all cheap tests.
  struct Candidate {
    Candidate(const plant::Random& own_random, double own_fate)
        : random(own_random), fate(own_fate) {}

    Site site;
    Surface::Spot spot;
    plant::Random random;
    double fate;
  };

  using FillNoise = void (ground::GroundRule::*)(std::span<const vec3>,
                                                 std::span<ground::GroundNoise>) const;

  void add_noise(std::vector<Candidate>& candidates, FillNoise fill) const {
    std::vector<vec3> positions;
    std::vector<ground::GroundNoise> noise;
    positions.reserve(candidates.size());
    noise.reserve(candidates.size());
    for (const Candidate& candidate : candidates) {
      positions.push_back(candidate.site.position);
      noise.push_back(candidate.site.noise);
    }
    (place_.rule.*fill)(positions, noise);
    for (std::size_t i = 0; i < candidates.size(); ++i) candidates[i].site.noise = noise[i];
  }

  std::vector<Candidate> candidates_of_row(std::int64_t j) const {
    std::vector<Candidate> candidates;
    const double z = (static_cast<double>(j) + 0.5) * layer_.spacing_m - place_.center.y;
    const double reach = layer_.reach_m + layer_.spacing_m;
    if (std::abs(z) > reach) return candidates;
    const double half = std::sqrt(reach * reach - z * z);
    const auto square = [this](double x) {
      return static_cast<std::int64_t>(std::floor(x / layer_.spacing_m));
    };
    const std::int64_t last = square(place_.center.x + half);
    const RowRandom random(place_.seed, layer_.id, j);
    candidates.reserve(512);
    std::optional<Sight::Row> sight;
    if (place_.sight != nullptr) sight = place_.sight->row(middle(j) - origin_.z);
    for (std::int64_t i = square(place_.center.x - half); i <= last; ++i) {
      if (sight && !sight->matters(middle(i) - origin_.x)) continue;
      add_candidate(i, j, random.square(i), candidates);
    }
    return candidates;
  }

  double middle(std::int64_t cell) const {
    return (static_cast<double>(cell) + 0.5) * layer_.spacing_m;
  }

  void add_candidate(std::int64_t i, std::int64_t j, plant::Random random,
                     std::vector<Candidate>& candidates) const {
    const auto stray = [&](std::int64_t cell) {
      return (static_cast<double>(cell) + 0.5 + kJitter * (random.unit() - 0.5)) * layer_.spacing_m;
    };
    const double x = stray(i), z = stray(j);
    const dvec2 from_center(x - place_.center.x, z - place_.center.y);
    const double distance = std::sqrt(glm::dot(from_center, from_center));
    if (random.unit() >= kept_at(distance, layer_.reach_m)) return;
    const double fate = random.unit();
    if (!(fate < static_cast<double>(layer_.most))) return;
    if (!place_.surface.covers(x, z)) return;
    // The candidate is made in the vector itself, because one made elsewhere would have to be
    // copied.
    Candidate& candidate = candidates.emplace_back(random, fate);
    if (!stand(x, z, candidate)) candidates.pop_back();
  }

  /// Puts a candidate on the ground. Returns whether the ground suits the layer.
  bool stand(double x, double z, Candidate& candidate) const {
    Surface::Spot& spot = candidate.spot;
    Site& site = candidate.site;
    place_.surface.find(x, z, spot);
    site.position = place_.surface.place(spot);
    const float height = place_.rule.height_above_sea(site.position);
    site.position.y = height;
    if (height < layer_.lowest || height > layer_.highest) return false;
    site.above_sea = height - place_.sea_level_m;
    if (!(layer_.steepest_cos > 0.0f)) return true;
    site.normal = place_.surface.normal(spot);
    return site.normal.y >= layer_.steepest_cos;
  }

  void grow(Candidate& candidate, std::vector<Instance>& row) const {
    Site& site = candidate.site;
    // The normals of the other layers are known already.
    if (!(layer_.steepest_cos > 0.0f)) site.normal = place_.surface.normal(candidate.spot);
    if (!(candidate.fate < static_cast<double>(layer_.chance(site)))) return;
    const Choice choice = layer_.choose(site, candidate.random);
    if (choice.is_nothing) return;
    const double height =
        choice.species ? choice.extent_m
                       : plant::model_height(choice.model) * static_cast<double>(choice.scale);
    if (height > place_.tallest_m) {
      throw Error(ErrorKind::internal,
                  fmt::format("a {} of {:.1f} m grows where {:.1f} m were expected at most",
                              choice.species ? "plant from a file"
                                             : plant::species_name(choice.model.species),
                              height, place_.tallest_m));
    }
    const double reach = kPlantReach * height;
    const dvec2 foot(site.position.x, site.position.z);
    if (place_.keep_out.hold(foot, reach)) return;
    row.push_back(instance_of(candidate, choice));
  }

  Instance instance_of(Candidate& candidate, const Choice& choice) const {
    const Site& site = candidate.site;
    plant::Random& random = candidate.random;
    Instance instance;
    instance.position = candidate.spot.position;
    instance.yaw_rad = static_cast<float>(random.turn());
    const vec3 axis = glm::normalize(glm::mix(site.normal, vec3(0.0f, 1.0f, 0.0f), choice.upright) +
                                     vec3(choice.lean.x, 0.0f, choice.lean.y));
    instance.lean = {axis.x, axis.z};
    instance.scale = choice.scale;
    instance.tint = choice.tint;
    if (choice.species) {
      instance.model = static_cast<std::uint32_t>(models_.size() + *choice.species);
      return instance;
    }
    const auto found = std::find(models_.begin(), models_.end(), choice.model);
    instance.model = static_cast<std::uint32_t>(found - models_.begin());
    return instance;
  }

  const Layer& layer_;
  const Place& place_;
  std::span<const plant::ModelKey> models_;
  dvec3 origin_;
};

}  // namespace

std::vector<Instance> place_layer(const Layer& layer, const Place& place,
                                  std::span<const plant::ModelKey> models) {
  const Planter planter(layer, place, models);
  const auto row_of = [&layer](double z) {
    return static_cast<std::int64_t>(std::floor(z / layer.spacing_m));
  };
  const std::int64_t first = row_of(place.center.y - layer.reach_m) - 1;
  const std::int64_t last = row_of(place.center.y + layer.reach_m) + 1;
  std::vector<std::vector<Instance>> rows(static_cast<std::size_t>(last - first + 1));
  tbb::parallel_for(first, last + 1, [&, stop = current_stop()](std::int64_t j) {
    stop_if_asked(stop);
    rows[static_cast<std::size_t>(j - first)] = planter.plant_row(j);
  });
  std::size_t total = 0;
  for (const auto& row : rows) total += row.size();
  std::vector<Instance> instances;
  instances.reserve(total);
  for (const auto& row : rows) instances.insert(instances.end(), row.begin(), row.end());
  return instances;
}

}  // namespace aerostat::scatter
