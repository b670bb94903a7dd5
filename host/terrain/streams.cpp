#include "streams.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "blend.hpp"
#include "core/simd.hpp"
#include "core/smooth_step.hpp"
#include "receivers.hpp"

namespace aerostat::terrain {
namespace {

// The slope that is enough for every node to lie above its receiver in single precision.
constexpr float kLeastSlope = 2e-4f;

/// The input of a round of erosion.
struct Round {
  const DrainageOptions& options;
  const RimmedGrid& grid;
  const RimmedRock& rock;
  const Rimmed<std::uint8_t>& sources;  // for each node, a bit for each neighbour that runs into it
  const int* ranks;                     // null if the heights give the order
  float strength;
};

/// Raises one stream system at a time. Its nodes are in order from the mouth upwards, each after
/// its receiver.
class System {
 public:
  System(const Round& round, Rimmed<float>& heights, std::vector<StreamNode>& room)
      : round_(round), heights_(heights), nodes_(room) {
    for (int d = 0; d < 8; ++d) steps_[d] = round.grid.step(d);
  }

  void raise(int mouth) {
    gather(mouth);
    accumulate();
    climb();
    for (std::size_t i = 1; i < nodes_.size(); ++i) heights_[nodes_[i].place] = nodes_[i].height;
  }

 private:
  void gather(int mouth);
  void gather_above(int number);
  void accumulate();
  void climb();
  float stream_slope(const StreamNode& node) const;

  bool comes_before(int a, int b) const {
    if (round_.ranks != nullptr) return round_.ranks[a] < round_.ranks[b];
    return heights_[a] < heights_[b] || (heights_[a] == heights_[b] && a < b);
  }

  Round round_;
  Rimmed<float>& heights_;
  std::array<int, 8> steps_;
  std::vector<StreamNode>& nodes_;
};

void System::gather(int mouth) {
  nodes_.clear();
  nodes_.push_back({mouth, -1, 0.0f, 0.0f, 0.0f, 0.0f, heights_[mouth]});
  for (int number = 0; number < static_cast<int>(nodes_.size()); ++number) gather_above(number);
}

/// Appends the nodes whose water runs into this one, in the order of comes_before.
void System::gather_above(int number) {
  const int place = nodes_[number].place;
  std::array<int, 8> found;  // directions in the order of comes_before
  int count = 0;
  for (unsigned rest = round_.sources[place]; rest != 0; rest &= rest - 1) {
    const int d = std::countr_zero(rest);
    int at = count++;
    for (; at > 0 && comes_before(place + steps_[d], place + steps_[found[at - 1]]); --at)
      found[at] = found[at - 1];
    found[at] = d;
  }
  for (int k = 0; k < count; ++k)
    nodes_.push_back(
        {place + steps_[found[k]], number, round_.grid.length(found[k]), 0.0f, 0.0f, 0.0f, 0.0f});
}

void System::accumulate() {
  const float cell = round_.grid.spacing_m * round_.grid.spacing_m;
  for (auto node = nodes_.rbegin(); node != nodes_.rend(); ++node) {
    node->discharge += cell * std::max(round_.rock.uplift[node->place], 0.01f);
    if (node->receiver >= 0) nodes_[node->receiver].discharge += node->discharge;
  }
}

float System::stream_slope(const StreamNode& node) const {
  const float slope = round_.strength * round_.rock.uplift[node.place] *
                      std::pow(node.discharge * 1e-6f, -round_.options.concavity);
  return std::clamp(slope, kLeastSlope, round_.rock.steepest[node.place]);
}

void System::climb() {
  const DrainageOptions& options = round_.options;
  for (StreamNode& node : nodes_) {
    const float area_km2 = node.discharge * 1e-6f;
    if (area_km2 > options.floor_area_km2)
      node.floor = options.floor_m * std::pow(area_km2, options.floor_growth);
    if (node.receiver < 0) continue;
    const StreamNode& receiver = nodes_[node.receiver];
    if (node.floor == 0.0f) {
      node.floor = receiver.floor;
      node.remoteness = receiver.remoteness + node.length;
    }
    float slope = stream_slope(node);
    if (node.floor > 0.0f)
      slope *= mix(0.12f, 1.0f, smooth_step(0.4f, 1.6f, node.remoteness / node.floor));
    node.height = receiver.height + node.length * std::max(slope, kLeastSlope);
  }
}

/// Returns for each node a bit for each of its neighbours whose water runs into it.
Rimmed<std::uint8_t> sources_of(const RimmedGrid& grid, const Rimmed<std::uint8_t>& directions) {
  Rimmed<std::uint8_t> sources(grid.size(), 0);
  tbb::parallel_for(tbb::blocked_range<int>(0, grid.nodes, 64), [&](const auto& rows) {
    for (int j = rows.begin(); j != rows.end(); ++j) {
      const std::uint8_t* from = &directions[grid.at(0, j)];
      std::uint8_t* to = &sources[grid.at(0, j)];
      in_vectors([&]() AEROSTAT_INLINE_LAMBDA {
        for (int d = 0; d < 8; ++d) {
          const std::uint8_t* neighbor = from + grid.step(d);
          const auto back = static_cast<std::uint8_t>(opposite(d));
          const auto bit = static_cast<std::uint8_t>(1u << d);
          for (int i = 0; i < grid.nodes; ++i)
            to[i] = static_cast<std::uint8_t>(to[i] | (neighbor[i] == back ? bit : 0));
        }
      });
    }
  });
  return sources;
}

}  // namespace

void Erosion::raise(const Rimmed<std::uint8_t>& directions, const Rimmed<int>* ranks,
                    float strength, Rimmed<float>& heights) {
  const Rimmed<std::uint8_t> sources = sources_of(grid_, directions);
  const Round round{options_, grid_, rock_, sources, ranks == nullptr ? nullptr : ranks->data(),
                    strength};
  std::vector<int> mouths;
  for (int j = 0; j < grid_.nodes; ++j)
    for (int place = grid_.at(0, j); place < grid_.at(grid_.nodes, j); ++place)
      if (directions[place] == kNoReceiver && sources[place] != 0) mouths.push_back(place);
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mouths.size(), 16), [&](const auto& range) {
    System system(round, heights, rooms_.local());
    for (std::size_t k = range.begin(); k != range.end(); ++k) system.raise(mouths[k]);
  });
}

}  // namespace aerostat::terrain
