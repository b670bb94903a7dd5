#include "world/group.hpp"

#include <atomic>
#include <utility>

namespace aerostat::world {
namespace {

struct EmptinessOf {
  bool operator()(const Objects& objects) const { return objects.empty(); }
  bool operator()(const HeightGrid& grid) const { return grid.mesh == nullptr; }
  bool operator()(const Instances& instances) const { return instances.places.empty(); }
};

}  // namespace

InstanceModel instance_model(Objects parts) {
  return {std::make_shared<const Objects>(std::move(parts))};
}

bool is_empty(const Shape& shape) {
  return std::visit(EmptinessOf(), shape);
}

Group make_group(const GroupKind& kind, Shape shape) {
  static std::atomic<std::uint64_t> last{0};
  return {&kind, ++last, std::make_shared<const Shape>(std::move(shape))};
}

}  // namespace aerostat::world
