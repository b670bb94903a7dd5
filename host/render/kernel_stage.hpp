#pragma once

#include <array>
#include <cstddef>
#include <numeric>

namespace aerostat::render {

/// The work of a launch by its kind: eye rays, rays that surfaces reflect, rays to lights, rays
/// towards the sky, and the light at surfaces.
enum class KernelStage { primary, bounced, shadow, ambient, shading };

inline constexpr std::array kKernelStages = {KernelStage::primary, KernelStage::bounced,
                                             KernelStage::shadow, KernelStage::ambient,
                                             KernelStage::shading};

/// A value for each kernel of a launch.
template <typename T>
struct PerStage {
  std::array<T, kKernelStages.size()> values{};

  T& operator[](KernelStage stage) { return values[static_cast<std::size_t>(stage)]; }
  const T& operator[](KernelStage stage) const { return values[static_cast<std::size_t>(stage)]; }

  T sum() const { return std::accumulate(values.begin(), values.end(), T{}); }
};

}  // namespace aerostat::render
