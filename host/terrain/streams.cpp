#include "streams.hpp"

#include <algorithm>
#include <cmath>

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include "blend.hpp"
#include "receivers.hpp"

namespace aerostat::terrain {
namespace {

// Enough for every node to lie above its receiver in single precision.
constexpr float kLeastSlope = 2e-4f;

/// What a round of erosion goes by.
struct Round {
  const DrainageOptions& options;
  const RimmedGrid& grid;
  const RimmedRock& rock;
  const Rimmed<std::uint8_t>& directions;
  const int* ranks;  // may be null
  float strength;
};

/// A stream system at a time: its nodes from the mouth upwards, each after its receiver.
class System {
 public:
  System(const Round& round, Rimmed<float>& heights) : round_(round), heights_(heights) {
    for (int d = 0; d < 8; ++d) steps_[d] = round.grid.step(d);
  }

  void raise(int mouth) {
    gather(mouth);
    if (nodes_.size() == 1) return;
    accumulate();
    climb();
    for (std::size_t i = 1; i < nodes_.size(); ++i) heights_[nodes_[i].place] = nodes_[i].height;
  }

 private:
  struct Node {
    int place;
    int receiver;      // its number in `nodes_`
    float length;      // of the way to it, metres
    float discharge;   // m^2 of catchment, weighted by uplift
    float floor;       // half width of the valley's floor, 0 if it has none
    float remoteness;  // metres from the floor's river, along the stream
    float height;
  };

  void gather(int mouth);
  void gather_above(int number);
  void accumulate();
  void climb();
  float stream_slope(const Node& node) const;

  bool comes_before(int a, int b) const {
    if (round_.ranks != nullptr) return round_.ranks[a] < round_.ranks[b];
    return heights_[a] < heights_[b] || (heights_[a] == heights_[b] && a < b);
  }

  Round round_;
  Rimmed<float>& heights_;
  std::array<int, 8> steps_;
  std::vector<Node> nodes_;
};

void System::gather(int mouth) {
  nodes_.clear();
  nodes_.push_back({mouth, -1, 0.0f, 0.0f, 0.0f, 0.0f, heights_[mouth]});
  for (int number = 0; number < static_cast<int>(nodes_.size()); ++number) gather_above(number);
}

/// Appends the nodes whose water runs into this one, in their order.
void System::gather_above(int number) {
  const int place = nodes_[number].place;
  std::array<int, 8> found;  // directions
  int count = 0;
  for (int d = 0; d < 8; ++d) {
    if (round_.directions[place + steps_[d]] != opposite(d)) continue;
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

float System::stream_slope(const Node& node) const {
  const float slope = round_.strength * round_.rock.uplift[node.place] *
                      std::pow(node.discharge * 1e-6f, -round_.options.concavity);
  return std::clamp(slope, kLeastSlope, round_.rock.steepest[node.place]);
}

void System::climb() {
  const DrainageOptions& options = round_.options;
  for (Node& node : nodes_) {
    const float area_km2 = node.discharge * 1e-6f;
    if (area_km2 > options.floor_area_km2)
      node.floor = options.floor_m * std::pow(area_km2, options.floor_growth);
    if (node.receiver < 0) continue;
    const Node& receiver = nodes_[node.receiver];
    if (node.floor == 0.0f) {
      node.floor = receiver.floor;
      node.remoteness = receiver.remoteness + node.length;
    }
    float slope = stream_slope(node);
    if (node.floor > 0.0f)
      slope *= mix(0.12f, 1.0f, ramp(0.4f, 1.6f, node.remoteness / node.floor));
    node.height = receiver.height + node.length * std::max(slope, kLeastSlope);
  }
}

}  // namespace

void Erosion::raise(const Rimmed<std::uint8_t>& directions, const Rimmed<int>* ranks,
                    float strength, Rimmed<float>& heights) const {
  const Round round{options_, grid_, rock_, directions, ranks == nullptr ? nullptr : ranks->data(),
                    strength};
  std::vector<int> mouths;
  for (int j = 0; j < grid_.nodes; ++j)
    for (int place = grid_.at(0, j); place < grid_.at(grid_.nodes, j); ++place)
      if (directions[place] == kNoReceiver) mouths.push_back(place);
  tbb::enumerable_thread_specific<System> systems([&] { return System(round, heights); });
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, mouths.size(), 16), [&](const auto& range) {
    System& system = systems.local();
    for (std::size_t k = range.begin(); k != range.end(); ++k) system.raise(mouths[k]);
  });
}

}  // namespace aerostat::terrain
