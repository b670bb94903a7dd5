#include "drainage.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <queue>

#include <tbb/parallel_for.h>
#include <tbb/parallel_sort.h>

#include "blend.hpp"
#include "core/stop_scope.hpp"
#include "noise.hpp"

namespace aerostat::terrain {
namespace {

// Enough for every node to lie above its receiver in single precision.
constexpr float kLeastSlope = 2e-4f;

constexpr std::array<std::array<int, 2>, 8> kNeighbors = {
    {{1, 0}, {0, 1}, {-1, 0}, {0, -1}, {1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};

/// The drainage tree of one round: nodes from the outlets upwards, each after its receiver.
struct Tree {
  std::vector<int> order;
  std::vector<int> rank;  // place of each node in `order`
  std::vector<int> receiver;
  std::vector<float> distance;
};

/// Height that one node in a thousand exceeds: a single summit says little about a range.
float peak_height(const HeightGrid& grid) {
  std::vector<float> values = grid.values;
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 999 / 1000);
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

class Carver {
 public:
  Carver(const DrainageOptions& options, HeightGrid grid, std::vector<Bedrock> bedrock)
      : options_(options), grid_(std::move(grid)), bedrock_(std::move(bedrock)) {}

  HeightGrid run(int rounds, float& strength) {
    for (int round = 0; round < rounds; ++round) {
      stop_if_asked(stop_);
      // Only what comes from outside has basins: raised ground falls from node to receiver.
      round == 0 ? flood() : sort_by_height();
      choose_receivers();
      accumulate();
      raise(strength);
      const float top = peak_height(grid_);
      const float ratio = static_cast<float>(options_.height_m) / std::max(top, 1.0f);
      strength *= std::clamp(ratio, 0.25f, 4.0f);
    }
    return grid_;
  }

 private:
  // Random streams bend: on a regular grid the steepest neighbour alone gives straight lines.
  float reluctance(int node, int direction) const {
    const std::uint32_t h = lattice_hash(options_.seed, node, direction);
    return 0.7f + 0.6f * static_cast<float>(h >> 8) / 16777216.0f;
  }

  int neighbor(int row, int column, int direction) const {
    const int i = column + kNeighbors[direction][0];
    const int j = row + kNeighbors[direction][1];
    const bool inside = i >= 0 && j >= 0 && i < grid_.nodes && j < grid_.nodes;
    return inside ? j * grid_.nodes + i : -1;
  }

  float step_length(int direction) const {
    return grid_.spacing_m * (direction < 4 ? 1.0f : 1.41421356f);
  }

  std::size_t count() const { return grid_.values.size(); }

  void flood();
  void sort_by_height();
  void choose_receivers();
  void choose_receiver(int row, int column);
  void accumulate();
  float stream_slope(int node, float strength) const;
  void raise(float strength);

  const std::stop_token stop_ = current_stop();
  DrainageOptions options_;
  HeightGrid grid_;
  std::vector<Bedrock> bedrock_;
  std::vector<float> discharge_;  // m^2 of catchment, weighted by uplift
  Tree tree_;
};

void Carver::flood() {
  using Entry = std::pair<float, int>;
  std::vector<Entry> storage;
  storage.reserve(count());
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue({}, std::move(storage));
  std::vector<char> seen(count(), 0);
  tree_.order.clear();
  for (int node = 0; node < static_cast<int>(count()); ++node)
    if (bedrock_[node].outlet) {
      grid_.values[node] = bedrock_[node].outlet_m;
      queue.emplace(grid_.values[node], node);
      seen[node] = 1;
    }
  while (!queue.empty()) {
    const auto [level, node] = queue.top();
    queue.pop();
    tree_.order.push_back(node);
    for (int d = 0; d < 8; ++d) {
      const int other = neighbor(node / grid_.nodes, node % grid_.nodes, d);
      if (other < 0 || seen[other] != 0) continue;
      seen[other] = 1;
      queue.emplace(std::max(level, grid_.values[other]), other);
    }
  }
}

void Carver::sort_by_height() {
  // Height and node in one integer compare as fast as they can: heights are floats, whose bits
  // order like integers once the negative ones are turned round.
  std::vector<std::uint64_t> keys(count());
  tbb::parallel_for(0, static_cast<int>(count()), [&](int node) {
    const auto bits = std::bit_cast<std::uint32_t>(grid_.values[node] + 0.0f);
    const std::uint32_t ordered = (bits >> 31) != 0 ? ~bits : bits | 0x80000000u;
    keys[node] = std::uint64_t{ordered} << 32 | static_cast<std::uint32_t>(node);
  });
  tbb::parallel_sort(keys.begin(), keys.end());
  tbb::parallel_for(0, static_cast<int>(count()), [&](int i) {
    tree_.order[i] = static_cast<int>(static_cast<std::uint32_t>(keys[i]));
  });
}

void Carver::choose_receivers() {
  tree_.rank.resize(count());
  tree_.receiver.assign(count(), -1);
  tree_.distance.assign(count(), 0.0f);
  for (std::size_t i = 0; i < count(); ++i) tree_.rank[tree_.order[i]] = static_cast<int>(i);
  tbb::parallel_for(0, grid_.nodes, [this](int row) {
    for (int column = 0; column < grid_.nodes; ++column)
      if (!bedrock_[row * grid_.nodes + column].outlet) choose_receiver(row, column);
  });
}

void Carver::choose_receiver(int row, int column) {
  const int node = row * grid_.nodes + column;
  float best = -std::numeric_limits<float>::infinity();
  for (int d = 0; d < 8; ++d) {
    const int other = neighbor(row, column, d);
    if (other < 0 || tree_.rank[other] > tree_.rank[node]) continue;
    const float drop = (grid_.values[node] - grid_.values[other]) / step_length(d);
    const float preference = drop >= 0.0f ? drop * reluctance(node, d) : drop;
    if (preference <= best) continue;
    best = preference;
    tree_.receiver[node] = other;
    tree_.distance[node] = step_length(d);
  }
}

void Carver::accumulate() {
  const float cell = grid_.spacing_m * grid_.spacing_m;
  discharge_.assign(grid_.values.size(), 0.0f);
  for (auto it = tree_.order.rbegin(); it != tree_.order.rend(); ++it) {
    discharge_[*it] += cell * std::max(bedrock_[*it].uplift, 0.01f);
    if (tree_.receiver[*it] >= 0) discharge_[tree_.receiver[*it]] += discharge_[*it];
  }
}

float Carver::stream_slope(int node, float strength) const {
  const Bedrock& rock = bedrock_[node];
  const float slope =
      strength * rock.uplift * std::pow(discharge_[node] * 1e-6f, -options_.concavity);
  return std::clamp(slope, kLeastSlope, rock.steepest);
}

void Carver::raise(float strength) {
  std::vector<float> slopes(count());
  std::vector<float> floors(count());  // half width of the valley's floor, 0 if it has none
  tbb::parallel_for(0, static_cast<int>(count()), [&](int node) {
    const float area_km2 = discharge_[node] * 1e-6f;
    slopes[node] = stream_slope(node, strength);
    floors[node] = area_km2 > options_.floor_area_km2
                       ? options_.floor_m * std::pow(area_km2, options_.floor_growth)
                       : 0.0f;
  });
  std::vector<float> remoteness(count(), 0.0f);  // metres from the floor's river, along the stream
  for (const int node : tree_.order) {
    const int receiver = tree_.receiver[node];
    if (receiver < 0) continue;
    if (floors[node] == 0.0f) {
      floors[node] = floors[receiver];
      remoteness[node] = remoteness[receiver] + tree_.distance[node];
    }
    float slope = slopes[node];
    if (floors[node] > 0.0f)
      slope *= mix(0.12f, 1.0f, ramp(0.4f, 1.6f, remoteness[node] / floors[node]));
    grid_.values[node] =
        grid_.values[receiver] + tree_.distance[node] * std::max(slope, kLeastSlope);
  }
}

std::vector<Bedrock> survey(const HeightGrid& grid,
                            const std::function<void(const Points&, Bedrock*)>& bedrock) {
  std::vector<Bedrock> result(grid.values.size());
  const int count = static_cast<int>(grid.values.size());
  tbb::parallel_for(0, (count + kBlockSize - 1) / kBlockSize, [&](int block) {
    const int begin = block * kBlockSize;
    Points points;
    points.count = std::min(kBlockSize, count - begin);
    for (int k = 0; k < points.count; ++k) {
      points.x[k] = grid.x((begin + k) % grid.nodes);
      points.z[k] = grid.x((begin + k) / grid.nodes);
      points.spacing[k] = grid.spacing_m;
    }
    bedrock(points, &result[static_cast<std::size_t>(begin)]);
  });
  const bool drained =
      std::any_of(result.begin(), result.end(), [](const Bedrock& rock) { return rock.outlet; });
  if (!drained) result.front().outlet = true;
  return result;
}

}  // namespace

HeightGrid carve_valleys(const DrainageOptions& options,
                         const std::function<void(const Points&, Bedrock*)>& bedrock) {
  HeightGrid grid = make_grid(options.coarse_nodes, options.size_m);
  for (std::size_t i = 0; i < grid.values.size(); ++i)
    grid.values[i] = static_cast<float>(lattice_hash(options.seed, static_cast<int>(i), -1) >> 16) *
                     static_cast<float>(options.height_m) * 1e-7f;
  float strength = 0.3f;
  const std::size_t levels =
      options.rounds.size() - static_cast<std::size_t>(options.levels_left_out);
  for (std::size_t level = 0; level < levels; ++level) {
    if (level > 0) grid = refine(grid);
    std::vector<Bedrock> rock = survey(grid, bedrock);
    grid = Carver(options, std::move(grid), std::move(rock)).run(options.rounds[level], strength);
  }
  const float top = peak_height(grid);
  if (top > 0.0f)
    for (float& value : grid.values) value *= static_cast<float>(options.height_m) / top;
  return grid;
}

}  // namespace aerostat::terrain
