#include <algorithm>
#include <functional>
#include <map>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/error.hpp"
#include "device_bench.hpp"
#include "report.hpp"
#include "scene/io.hpp"
#include "soup.hpp"
#include "world/resolve.hpp"
#ifdef AEROSTAT_EMBREE
#include "embree_peer.hpp"
#include "scene/scene.hpp"
#endif

namespace {

using namespace aerostat;
using nlohmann::ordered_json;

struct Arguments {
  std::string scene;
  std::size_t soup = 0;  // number of triangles; 0: the scene
  std::string device;
  std::vector<std::string> set;
  std::vector<std::string> kinds;  // kinds of rays; empty: all
  int width = 1920, height = 1080;
  int lanes = 0;
  int rounds = 7;
  std::vector<std::string> against;  // folders of kernels
  bool peers = true;
  bool plants = false;
  bool json = false;
};

/// One thing to time: a tracer of a kind of ray, or a builder.
struct Entry {
  std::string kind, tracer;
  std::uint64_t count;  // number of rays or triangles
  std::function<double()> seconds;
};

/// Times the entries in turn, A B C A B C ..., so that a machine whose speed drifts is fair to
/// all of them.
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
    const double rate = static_cast<double>(entry.count) / bench::median(times[i]) / 1e6;
    if (own.count(entry.kind) == 0) own[entry.kind] = rate;
    const double best = *std::min_element(times[i].begin(), times[i].end());
    ordered_json figures{{"millions_per_s", rate},
                         {"best_millions_per_s", static_cast<double>(entry.count) / best / 1e6},
                         {"count", entry.count}};
    if (entry.tracer.find("aerostat") != 0) figures["aerostat_ratio"] = own[entry.kind] / rate;
    result[entry.kind][entry.tracer] = figures;
  }
  return result;
}

ordered_json as_json(const bench::PacketCounts& counts) {
  return {{"nodes", counts.nodes}, {"leaves", counts.leaves}, {"triangles", counts.triangles}};
}

render::BuiltGeometry build(const Arguments& arguments) {
  if (arguments.soup > 0) {
    return bench::build_soup(arguments.soup, arguments.width, arguments.height);
  }
  std::vector<scene::Override> overrides;
  for (const auto& text : arguments.set) overrides.push_back(scene::parse_override(text));
  scene::Scene scene = scene::read_file(arguments.scene, overrides);
  scene.image.width = arguments.width;
  scene.image.height = arguments.height;
  if (!arguments.plants) scene.vegetation.enabled = false;
  world::ReliefCache reliefs;
  render::GeometryOptions options;
  options.reliefs = &reliefs;
  return render::build_geometry(world::resolve(scene, reliefs), nullptr, options);
}

ordered_json describe(const Arguments& arguments, const bench::DeviceBench& device,
                      const std::string& device_name, const render::HostGeometry& geometry) {
  const auto& buffers = device.geometry();
  const auto triangles = static_cast<double>(buffers.triangle_count());
  return {{"scene", arguments.soup > 0 ? "soup" : arguments.scene},
          {"device", device_name},
          {"lanes", device.lanes()},
          {"width", arguments.width},
          {"height", arguments.height},
          {"rounds", arguments.rounds},
          {"triangles", buffers.triangle_count()},
          {"instances", buffers.instances.size()},
          {"bytes_per_triangle", static_cast<double>(buffers.bytes()) / triangles},
          {"tree_bytes_per_triangle", static_cast<double>(buffers.nodes.bytes()) / triangles},
          {"nodes", buffers.tree.nodes},
          {"leaves", buffers.tree.leaves},
          {"sah_cost", buffers.tree.sah_cost},
          {"world_seconds", geometry.world_seconds},
          {"tree_seconds", geometry.tree_seconds}};
}

/// A kind of ray. `coherent` is the hint that Embree is given.
struct Kind {
  std::string name;
  std::reference_wrapper<const bench::RaySet> rays;
  bool any_hit, coherent;
};

#ifdef AEROSTAT_EMBREE
void add_peer(const bench::EmbreePeer& embree, const Kind& kind, std::vector<Entry>& entries) {
  const bench::RaySet& rays = kind.rays.get();
  const std::string name = kind.any_hit ? "Embree rtcOccluded" : "Embree rtcIntersect";
  const auto coherence = kind.coherent ? bench::Coherence::coherent : bench::Coherence::incoherent;
  entries.push_back({kind.name, name + "1", rays.active(), [&, any_hit = kind.any_hit] {
                       return any_hit ? embree.time_occluded_1(rays) : embree.time_closest_1(rays);
                     }});
  if (rays.lanes == 1) return;
  entries.push_back({kind.name,
                     fmt::format("{}{}{}", name, rays.lanes, kind.coherent ? ", coherent" : ""),
                     rays.active(), [&, coherence, any_hit = kind.any_hit] {
                       return any_hit ? embree.time_occluded_packets(rays, coherence)
                                      : embree.time_closest_packets(rays, coherence);
                     }});
}

/// Times both builders on the soup.
ordered_json time_builds(const mesh::TriangleMesh& mesh, const bench::EmbreePeer& embree,
                         int rounds) {
  const auto own = [&] { return bvh::build(mesh.positions, mesh.triangles).stats.seconds; };
  const auto triangles = static_cast<std::uint64_t>(mesh.triangles.size());
  return time_entries({{"build", "aerostat", triangles, own},
                       {"build", "Embree", triangles, [&] { return embree.time_commit(mesh); }}},
                      rounds)["build"];
}
#endif

/// Returns the kinds of rays that the arguments ask for.
std::vector<Kind> kinds_of(const Arguments& arguments, const bench::RaySet& camera,
                           const bench::RaySet& shadow, const bench::RaySet& bounce) {
  std::vector<Kind> kinds{{"primary", camera, false, true},
                          {"shadow", shadow, true, true},
                          {"incoherent", bounce, false, false},
                          {"occlusion", bounce, true, false}};
  const auto& asked = arguments.kinds;
  std::erase_if(kinds, [&](const Kind& kind) {
    return !asked.empty() && std::find(asked.begin(), asked.end(), kind.name) == asked.end();
  });
  return kinds;
}

void add_kernels(bench::DeviceBench& device, const std::string& name,
                 const std::vector<Kind>& kinds, std::vector<Entry>& entries) {
  for (const Kind& kind : kinds) {
    entries.push_back({kind.name, name, kind.rays.get().active(),
                       [&] { return device.time_rays(kind.rays, kind.any_hit); }});
  }
}

void add_renderers_kernels(bench::DeviceBench& device, const std::vector<Kind>& kinds,
                           std::vector<Entry>& entries) {
  for (const Kind& kind : kinds) {
    const std::string name = "aerostat, renderer's kernel";
    const std::uint64_t count = kind.rays.get().active();
    if (kind.name == "primary") {
      entries.push_back({kind.name, name, count, [&] { return device.time_camera_kernel(); }});
    } else if (kind.name == "shadow") {
      entries.push_back({kind.name, name, count, [&] { return device.time_shadow_kernel(); }});
    }
  }
}

void run(const Arguments& arguments) {
  const auto device = opencl::select_device(opencl::effective_selector(arguments.device));
  render::BuiltGeometry built = build(arguments);
  const auto geometry = built.geometry;
  const scene::ResolvedScene& scene = geometry->world.scene;
  const render::Frame frame = render::only_frame(std::move(built));
  bench::DeviceBench own(device, arguments.lanes, scene, frame, opencl::kernel_sources());
  const bench::RaySet camera = own.camera_rays(), shadow = own.shadow_rays();
  const bench::RaySet bounce = own.bounce_rays();
  ordered_json figures = describe(arguments, own, device.name, *geometry);
  const std::vector<Kind> kinds = kinds_of(arguments, camera, shadow, bounce);

  std::vector<Entry> entries;
  add_kernels(own, "aerostat", kinds, entries);
  add_renderers_kernels(own, kinds, entries);
  std::vector<std::unique_ptr<bench::DeviceBench>> others;
  for (const auto& folder : arguments.against) {
    others.push_back(std::make_unique<bench::DeviceBench>(device, arguments.lanes, scene, frame,
                                                          opencl::kernel_sources(folder)));
    add_kernels(*others.back(), "kernels of " + folder, kinds, entries);
  }
#ifdef AEROSTAT_EMBREE
  std::unique_ptr<bench::EmbreePeer> embree;
  if (arguments.peers) {
    embree = std::make_unique<bench::EmbreePeer>(*geometry);
    figures["embree_commit_seconds"] = embree->commit_seconds();
    if (arguments.soup > 0) {
      figures["build"] = time_builds(bench::mesh_of_soup(*geometry), *embree, arguments.rounds);
    }
    for (const Kind& kind : kinds) add_peer(*embree, kind, entries);
  }
#endif
  figures["rays"] = time_entries(entries, arguments.rounds);
  for (const Kind& kind : kinds) {
    figures["rays"][kind.name]["per_packet"] = as_json(own.count(kind.rays, kind.any_hit));
  }
  fmt::print("{}", arguments.json ? figures.dump(2) + "\n" : bench::table(figures));
}

}  // namespace

int main(int argc, char** argv) {
  Arguments arguments;
  CLI::App app{"Rays per second of a scene on an OpenCL device, beside Embree on the same rays"};
  auto* scene = app.add_option("scene", arguments.scene, "Scene file");
  auto* soup = app.add_option("--soup", arguments.soup,
                              "In place of a scene: so many triangles without order, and the time "
                              "of building their tree")
                   ->check(CLI::Range(1000, 100000000))
                   ->excludes(scene);
  app.add_option("--device", arguments.device, "OpenCL device, as for aerostat");
  app.add_option("--lanes", arguments.lanes, "Rays per work-item")
      ->check(CLI::IsMember({1, 4, 8, 16}));
  app.add_flag("--plants", arguments.plants, "Keep the plants, which Embree gets as instances");
  app.add_option("--set", arguments.set, "/json/pointer=value");
  app.add_option("--kinds", arguments.kinds, "The kinds of rays to time, such as primary,shadow")
      ->delimiter(',')
      ->check(CLI::IsMember({"primary", "shadow", "incoherent", "occlusion"}));
  app.add_option("--width", arguments.width, "Pixels")->check(CLI::Range(16, 16384));
  app.add_option("--height", arguments.height, "Pixels")->check(CLI::Range(16, 16384));
  app.add_option("--rounds", arguments.rounds, "Timed rounds")->check(CLI::Range(1, 1000));
  app.add_option("--against", arguments.against,
                 "Folders of kernels to time in turn with the renderer's");
  app.add_flag("!--no-peers", arguments.peers, "Time the renderer's rays alone");
  app.add_flag("--json", arguments.json, "Figures as JSON");
  CLI11_PARSE(app, argc, argv);
  if (scene->empty() == soup->empty()) {
    fmt::print(stderr, "aerostat_bench: give a scene file or --soup\n");
    return static_cast<int>(ErrorKind::usage);
  }
  try {
    run(arguments);
  } catch (const Error& error) {
    fmt::print(stderr, "aerostat_bench: {}\n", error.what());
    return error.exit_code();
  }
  return 0;
}
