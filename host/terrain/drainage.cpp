#include "drainage.hpp"

#include <algorithm>
#include <limits>

#include <tbb/parallel_for.h>

#include "core/stop_scope.hpp"
#include "flood.hpp"
#include "noise.hpp"
#include "receivers.hpp"
#include "streams.hpp"

namespace aerostat::terrain {
namespace {

/// Returns the height that one node in a thousand exceeds. A single summit would tell little
/// about a range.
float peak_height(const RimmedGrid& grid, const Rimmed<float>& heights) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(grid.nodes) * static_cast<std::size_t>(grid.nodes));
  for (int j = 0; j < grid.nodes; ++j)
    values.insert(values.end(), &heights[grid.at(0, j)], &heights[grid.at(grid.nodes, j)]);
  const auto rank = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 999 / 1000);
  std::nth_element(values.begin(), rank, values.end());
  return *rank;
}

/// Carves the valleys of one level.
class Carver {
 public:
  Carver(const DrainageOptions& options, const HeightGrid& grid, const std::vector<Bedrock>& rock)
      : options_(options),
        grid_{grid.nodes, grid.spacing_m},
        heights_(grid_.size(), std::numeric_limits<float>::infinity()) {
    rock_.uplift.resize(grid_.size());
    rock_.steepest.resize(grid_.size());
    rock_.outlets.assign(grid_.size(), 0);
    tbb::parallel_for(0, grid.nodes, [&](int j) {
      for (int i = 0; i < grid.nodes; ++i) {
        const Bedrock& bedrock = rock[grid.index(i, j)];
        const int place = grid_.at(i, j);
        heights_[place] = bedrock.outlet ? bedrock.outlet_m : grid.values[grid.index(i, j)];
        rock_.uplift[place] = bedrock.uplift;
        rock_.steepest[place] = bedrock.steepest;
        rock_.outlets[place] = bedrock.outlet ? 1 : 0;
      }
    });
  }

  void run(int rounds, float& strength) {
    Erosion erosion(options_, grid_, rock_);
    for (int round = 0; round < rounds; ++round) {
      stop_if_asked(stop_);
      if (round == 0) {
        // Only ground that comes from outside has basins. Raised ground falls from each node to
        // its receiver.
        const auto ranks = flood_ranks(grid_, heights_, rock_.outlets);
        const auto directions =
            receivers_by_rank(grid_, heights_, ranks, rock_.outlets, options_.seed);
        erosion.raise(directions, &ranks, strength, heights_);
      } else {
        const auto directions = receivers_by_height(grid_, heights_, rock_.outlets, options_.seed);
        erosion.raise(directions, nullptr, strength, heights_);
      }
      const float ratio =
          static_cast<float>(options_.height_m) / std::max(peak_height(grid_, heights_), 1.0f);
      strength *= std::clamp(ratio, 0.25f, 4.0f);
    }
  }

  float peak() const { return peak_height(grid_, heights_); }

  void store(HeightGrid& grid) const {
    for (int j = 0; j < grid_.nodes; ++j)
      std::copy_n(&heights_[grid_.at(0, j)], grid_.nodes, &grid.values[grid.index(0, j)]);
  }

 private:
  const std::stop_token stop_ = current_stop();
  const DrainageOptions& options_;
  RimmedGrid grid_;
  RimmedRock rock_;
  Rimmed<float> heights_;
};

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
  float strength = 0.3f, top = 0.0f;
  const std::size_t levels =
      options.rounds.size() - static_cast<std::size_t>(options.levels_left_out);
  for (std::size_t level = 0; level < levels; ++level) {
    if (level > 0) grid = refine(grid);
    Carver carver(options, grid, survey(grid, bedrock));
    carver.run(options.rounds[level], strength);
    carver.store(grid);
    top = carver.peak();
  }
  if (top > 0.0f)
    for (float& value : grid.values) value *= static_cast<float>(options.height_m) / top;
  return grid;
}

}  // namespace aerostat::terrain
