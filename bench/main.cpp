#include <functional>
#include <map>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.hpp"
#include "device_bench.hpp"
#include "report.hpp"
#include "scene/io.hpp"
#include "world/world.hpp"
#ifdef AEROSTAT_HAVE_EMBREE
#include "embree_peer.hpp"
#endif

namespace {

using namespace aerostat;
using nlohmann::ordered_json;

struct Arguments {
  std::string scene;
  std::string device;
  std::vector<std::string> set;
  int width = 1920, height = 1080;
  int lanes = 0;
  int rounds = 7;
  bool json = false;
};

/// Something to time: a tracer of a kind of ray.
struct Entry {
  std::string kind, tracer;
  std::uint64_t rays;
  std::function<double()> seconds;
};

/// Times the entries in turn, A B C A B C ..., so that a machine whose speed drifts is fair to all.
ordered_json time_entries(const std::vector<Entry>& entries, int rounds) {
  std::vector<std::vector<double>> times(entries.size());
  for (const auto& entry : entries) entry.seconds();
  for (int round = 0; round < rounds; ++round) {
    for (std::size_t i = 0; i < entries.size(); ++i) times[i].push_back(entries[i].seconds());
  }
  ordered_json result;
  std::map<std::string, double> own;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const auto& entry = entries[i];
    const double rate = static_cast<double>(entry.rays) / bench::median(times[i]) / 1e6;
    if (own.count(entry.kind) == 0) own[entry.kind] = rate;
    ordered_json figures{{"mrays_per_s", rate}, {"rays", entry.rays}};
    if (entry.tracer.find("Embree") == 0) figures["aerostat_ratio"] = own[entry.kind] / rate;
    result[entry.kind][entry.tracer] = figures;
  }
  return result;
}

ordered_json as_json(const bench::PacketCounts& counts) {
  return {{"nodes", counts.nodes}, {"leaves", counts.leaves}, {"triangles", counts.triangles}};
}

scene::Scene read_scene(const Arguments& arguments) {
  std::vector<scene::Override> overrides;
  for (const auto& text : arguments.set) overrides.push_back(scene::parse_override(text));
  scene::Scene scene = scene::read_file(arguments.scene, overrides);
  scene.image.width = arguments.width;
  scene.image.height = arguments.height;
  world::resolve(scene);
  return scene;
}

ordered_json describe(const Arguments& arguments, const bench::DeviceBench& device,
                      const std::string& device_name, const render::HostGeometry& geometry) {
  const auto& buffers = device.geometry();
  const auto triangles = static_cast<double>(buffers.triangle_count());
  return {{"scene", arguments.scene},
          {"device", device_name},
          {"lanes", device.lanes()},
          {"width", arguments.width},
          {"height", arguments.height},
          {"rounds", arguments.rounds},
          {"triangles", buffers.triangle_count()},
          {"bytes_per_triangle", static_cast<double>(buffers.bytes()) / triangles},
          {"tree_bytes_per_triangle", static_cast<double>(buffers.nodes.bytes()) / triangles},
          {"nodes", buffers.tree.nodes},
          {"leaves", buffers.tree.leaves},
          {"sah_cost", buffers.tree.sah_cost},
          {"world_seconds", geometry.world_seconds},
          {"tree_seconds", geometry.tree_seconds}};
}

void run(const Arguments& arguments) {
  const auto device = opencl::select_device(opencl::effective_selector(arguments.device));
  const auto geometry = render::build_geometry(read_scene(arguments), nullptr);
  bench::DeviceBench own(device, arguments.lanes, *geometry);
  const bench::RaySet camera = own.camera_rays();
  const bench::RaySet shadow = own.shadow_rays();
  ordered_json figures = describe(arguments, own, device.name, *geometry);

  std::vector<Entry> entries{
      {"primary", "aerostat", camera.active(), [&] { return own.time_rays(camera, false); }},
      {"primary", "aerostat, renderer's kernel", camera.active(),
       [&] { return own.time_camera_kernel(); }},
      {"shadow", "aerostat", shadow.active(), [&] { return own.time_rays(shadow, true); }},
      {"shadow", "aerostat, renderer's kernel", shadow.active(),
       [&] { return own.time_shadow_kernel(); }}};
#ifdef AEROSTAT_HAVE_EMBREE
  const bench::EmbreePeer embree(*geometry);
  figures["embree_commit_seconds"] = embree.commit_seconds();
  entries.push_back({"primary", "Embree rtcIntersect1", camera.active(),
                     [&] { return embree.time_closest_1(camera); }});
  entries.push_back({"shadow", "Embree rtcOccluded1", shadow.active(),
                     [&] { return embree.time_occluded_1(shadow); }});
  if (own.lanes() == 16) {
    entries.push_back({"primary", "Embree rtcIntersect16, coherent", camera.active(),
                       [&] { return embree.time_closest_16(camera); }});
    entries.push_back({"shadow", "Embree rtcOccluded16, coherent", shadow.active(),
                       [&] { return embree.time_occluded_16(shadow); }});
  }
#endif
  figures["rays"] = time_entries(entries, arguments.rounds);
  figures["rays"]["primary"]["per_packet"] = as_json(own.count(camera, false));
  figures["rays"]["shadow"]["per_packet"] = as_json(own.count(shadow, true));
  fmt::print("{}", arguments.json ? figures.dump(2) + "\n" : bench::table(figures));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"Rays per second of a scene on an OpenCL device, beside Embree on the same rays"};
  app.add_option("scene", arguments.scene, "Scene file")->required();
  app.add_option("--device", arguments.device, "OpenCL device, as for aerostat");
  app.add_option("--lanes", arguments.lanes, "Rays per work-item")
      ->check(CLI::IsMember({1, 4, 8, 16}));
  app.add_option("--set", arguments.set, "/json/pointer=value");
  app.add_option("--width", arguments.width, "Pixels")->check(CLI::Range(16, 16384));
  app.add_option("--height", arguments.height, "Pixels")->check(CLI::Range(16, 16384));
  app.add_option("--rounds", arguments.rounds, "Timed rounds")->check(CLI::Range(1, 1000));
  app.add_flag("--json", arguments.json, "Figures as JSON");
  CLI11_PARSE(app, argc, argv);
  try {
    run(arguments);
  } catch (const Error& error) {
    fmt::print(stderr, "aerostat_bench: {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
