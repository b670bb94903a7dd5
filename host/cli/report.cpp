#include "cli/report.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "core/grouped.hpp"

namespace aerostat::cli {

namespace {

using render::KernelStage;

std::string name_of(KernelStage stage) {
  switch (stage) {
    case KernelStage::primary:
      return "  primary";
    case KernelStage::bounced:
      return "  bounced";
    case KernelStage::shadow:
      return "  shadow";
    case KernelStage::ambient:
      return "  ambient";
    case KernelStage::shading:
      break;
  }
  return "  shading";
}

/// Returns a line about the work of a kernel, or nothing for rays that were not asked for.
std::string stage_line(KernelStage stage, std::uint64_t rays, double device_seconds) {
  const std::string name = name_of(stage);
  if (stage == KernelStage::shading) {
    return fmt::format("{:<10}{:.2f} s on the device\n", name, device_seconds);
  }
  if (rays == 0) return {};
  std::string line = fmt::format("{:<10}{} rays", name, grouped(rays));
  if (device_seconds > 0.0) {
    line += fmt::format(", {:.2f} s on the device, {:.2f} Mrays/s", device_seconds,
                        static_cast<double>(rays) * 1e-6 / device_seconds);
  }
  return line + "\n";
}

double mebibytes(std::uint64_t bytes) {
  return static_cast<double>(bytes) / 0x1p20;
}

/// Returns a line about the work of each device.
std::string devices_text(const render::Stats& stats) {
  std::string text;
  for (const render::DeviceStats& one : stats.devices) {
    const double seconds = one.seconds[KernelStage::primary];
    const double busy = one.seconds.sum();
    const double share = static_cast<double>(one.primary_rays) /
                         static_cast<double>(stats.rays[KernelStage::primary]);
    const double rate = seconds > 0.0 ? static_cast<double>(one.primary_rays) / seconds : 0.0;
    text += fmt::format(
        "  on {}: {} primary rays, {:.1f} % of them, {:.2f} Mrays/s; busy for {:.2f} s, {:.1f} "
        "MiB\n",
        one.selector, grouped(one.primary_rays), 100.0 * share, rate * 1e-6, busy,
        mebibytes(one.bytes));
  }
  return text;
}

std::string built(int count) {
  return count == 0 ? "kept" : fmt::format("{} built", count);
}

}  // namespace

std::uint64_t peak_memory_bytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024u;
}

std::string stats_text(const render::Stats& stats, std::uint64_t peak_bytes) {
  const std::uint64_t rays = stats.rays.sum();
  const double rate =
      stats.rays_seconds > 0.0 ? static_cast<double>(rays) * 1e-6 / stats.rays_seconds : 0.0;
  std::string text;
  text += fmt::format("{:<10}{:.2f} s, {}, {} triangles\n", "world", stats.world_seconds,
                      built(stats.worlds_built), grouped(stats.triangles));
  text += fmt::format("{:<10}{:.2f} s, {}, {} nodes, {} leaves, SAH cost {:.1f}\n", "tree",
                      stats.tree_seconds, built(stats.trees_built), grouped(stats.tree.nodes),
                      grouped(stats.tree.leaves), stats.tree.sah_cost);
  text += fmt::format("{:<10}{:.2f} s, {}\n", "kernels", stats.kernel_seconds,
                      built(stats.programs_built));
  text += fmt::format("{:<10}{:.2f} s\n", "upload", stats.upload_seconds);
  text += fmt::format("{:<10}{:.2f} s\n", "metering", stats.metering_seconds);
  text += fmt::format("{:<10}{:.2f} s, {} rays, {:.2f} Mrays/s with shading\n", "tracing",
                      stats.rays_seconds, grouped(rays), rate);
  for (const KernelStage stage : render::kKernelStages) {
    text += stage_line(stage, stats.rays[stage], stats.device_seconds[stage]);
  }
  if (stats.devices.size() > 1) text += devices_text(stats);
  text += fmt::format("{:<10}{:.1f} MiB at most in the process, {:.1f} MiB of device buffers\n",
                      "memory", mebibytes(peak_bytes), mebibytes(stats.device_bytes));
  return text;
}

std::string seconds_text(const CommandSeconds& seconds) {
  return fmt::format(
      "{:<10}reading {:.3f} s, device {:.3f} s, placing {:.3f} s, denoising {:.3f} s, "
      "encoding {:.3f} s, writing {:.3f} s\n",
      "around it", seconds.reading, seconds.device, seconds.placing, seconds.denoising,
      seconds.encoding, seconds.writing);
}

}  // namespace aerostat::cli
