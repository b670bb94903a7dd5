#include "report.hpp"

#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

namespace aerostat::bench {
namespace {

std::string ray_rows(const nlohmann::ordered_json& rays) {
  std::string text =
      fmt::format("{:<12}{:<34}{:>10}{:>10}\n", "rays", "tracer", "Mrays/s", "ratio");
  for (const auto& [kind, tracers] : rays.items()) {
    for (const auto& [tracer, figures] : tracers.items()) {
      if (!figures.contains("millions_per_s")) continue;
      const std::string ratio = figures.contains("aerostat_ratio")
                                    ? fmt::format("{:.2f}", figures["aerostat_ratio"].get<double>())
                                    : "";
      text += fmt::format("{:<12}{:<34}{:>10.2f}{:>10}\n", kind, tracer,
                          figures["millions_per_s"].get<double>(), ratio);
    }
    const auto& counts = tracers["per_packet"];
    text += fmt::format("{:<12}per packet: {:.1f} nodes, {:.1f} leaves, {:.1f} triangles\n", kind,
                        counts["nodes"].get<double>(), counts["leaves"].get<double>(),
                        counts["triangles"].get<double>());
  }
  return text;
}

std::string build_rows(const nlohmann::ordered_json& builders) {
  std::string text = fmt::format("{:<46}{:>10}{:>10}\n", "general tree", "Mtris/s", "ratio");
  for (const auto& [builder, figures] : builders.items()) {
    const std::string ratio = figures.contains("aerostat_ratio")
                                  ? fmt::format("{:.2f}", figures["aerostat_ratio"].get<double>())
                                  : "";
    text += fmt::format("{:<46}{:>10.2f}{:>10}\n", builder, figures["millions_per_s"].get<double>(),
                        ratio);
  }
  return text + "\n";
}

}  // namespace

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

std::string table(const nlohmann::ordered_json& figures) {
  std::string text = fmt::format(
      "{} on {}, {} lanes, {} x {}, median of {} rounds\n", figures["scene"].get<std::string>(),
      figures["device"].get<std::string>(), figures["lanes"].get<int>(),
      figures["width"].get<int>(), figures["height"].get<int>(), figures["rounds"].get<int>());
  text += fmt::format("{} triangles, {:.1f} bytes on the device each ({:.1f} of them the tree)\n",
                      figures["triangles"].get<std::uint64_t>(),
                      figures["bytes_per_triangle"].get<double>(),
                      figures["tree_bytes_per_triangle"].get<double>());
  text += fmt::format("world {:.2f} s, tree {:.2f} s", figures["world_seconds"].get<double>(),
                      figures["tree_seconds"].get<double>());
  if (figures.contains("embree_commit_seconds")) {
    text += fmt::format(", Embree's tree {:.2f} s", figures["embree_commit_seconds"].get<double>());
  }
  text += fmt::format(", cost by surface area {:.2f}\n\n", figures["sah_cost"].get<double>());
  if (figures.contains("build")) text += build_rows(figures["build"]);
  return text + ray_rows(figures["rays"]);
}

}  // namespace aerostat::bench
