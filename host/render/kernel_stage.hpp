#pragma once

#include <array>
#include <cstddef>
#include <numeric>

namespace aerostat::render {

/// The kernels of a launch, in the order in which a device runs them over a tile.
enum class KernelStage { primary, shadow, ambient, shading };

inline constexpr std::array kKernelStages = {KernelStage::primary, KernelStage::shadow,
                                             KernelStage::ambient, KernelStage::shading};

/// A value for each kernel of a launch.
template <typename T>
struct PerStage {
  std::array<T, kKernelStages.size()> values{};

  T& operator[](KernelStage stage) { return values[static_cast<std::size_t>(stage)]; }
  const T& operator[](KernelStage stage) const { return values[static_cast<std::size_t>(stage)]; }

  T sum() const { return std::accumulate(values.begin(), values.end(), T{}); }
};

}  // namespace aerostat::render
