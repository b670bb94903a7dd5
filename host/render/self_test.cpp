#include "render/self_test.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/log.hpp"
#include "core/math.hpp"
#include "opencl/binaries.hpp"
#include "opencl/program.hpp"
#include "scene/io.hpp"
#include "scene/scene.hpp"
#include "world/group.hpp"
#include "world/resolve.hpp"

namespace aerostat::render {
namespace {

constexpr double kEyeHeight_m = 25.0;
constexpr int kWidth = 48, kHeight = 32;
constexpr double kAlbedo = 0.25;
constexpr scene::ObjectId kPlateId = scene::ObjectId::rim;

/// A level square in the air.
struct Plate {
  dvec3 centre;
  double half_m;
};

/// Plates of several sizes and heights, some of which overlap as seen from the eye. Chosen by eye.
constexpr std::array<Plate, 9> kPlates{{{{-9.1, 4.3, -5.2}, 1.7},
                                        {{-3.7, 9.9, -4.4}, 1.3},
                                        {{2.9, 2.1, -5.9}, 2.3},
                                        {{8.3, 7.7, -3.1}, 1.1},
                                        {{-6.3, 6.1, 3.9}, 2.1},
                                        {{-5.2, 11.7, 2.8}, 0.7},
                                        {{0.7, 3.3, 1.9}, 1.9},
                                        {{6.9, 5.3, 4.7}, 2.7},
                                        {{7.9, 12.3, 3.3}, 0.9}}};
/// The plates from this one on are instances of one model.
constexpr std::size_t kFirstInstance = 5;

/// Edges nearer than this are left out, because rounding decides there. In metres.
constexpr double kEdge_m = 1e-3;

mesh::TriangleMesh plate_mesh(const dvec3& centre, double half) {
  mesh::TriangleMesh mesh;
  for (const auto& [x, z] : {std::pair(-1.0, -1.0), {-1.0, 1.0}, {1.0, 1.0}, {1.0, -1.0}}) {
    mesh.positions.emplace_back(centre + half * dvec3(x, 0.0, z));
    mesh.normals.emplace_back(0.0f, 1.0f, 0.0f);
  }
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

const world::GroupKind kPlatesApart{
    .name = "plates",
    .build = [](const world::GroupInput&) -> world::Shape {
      world::Objects objects;
      for (std::size_t i = 0; i < kFirstInstance; ++i) {
        objects.push_back(
            {kPlateId, scene::MaterialId::rim, plate_mesh(kPlates[i].centre, kPlates[i].half_m)});
      }
      return objects;
    },
    .same = [](const world::GroupRequest&, const world::GroupRequest&) { return true; }};

const world::GroupKind kPlatesOfOneModel{
    .name = "instances of a plate",
    .footing = world::Footing::on_ground,
    .build = [](const world::GroupInput&) -> world::Shape {
      world::Instances instances;
      instances.are_plants = false;
      instances.models.push_back(
          world::instance_model({{kPlateId, scene::MaterialId::rim, plate_mesh(dvec3(0.0), 1.0)}}));
      for (std::size_t i = kFirstInstance; i < kPlates.size(); ++i) {
        scatter::Instance instance;
        instance.position = vec3(kPlates[i].centre);
        instance.scale = static_cast<float>(kPlates[i].half_m);
        instances.places.push_back(instance);
      }
      return instances;
    },
    .same = [](const world::GroupRequest&, const world::GroupRequest&) { return true; }};

/// Makes the ground a level plane of one colour at the height 0.
void make_plane(scene::Scene& scene) {
  scene::Ground& ground = scene.biome.ground;
  ground = {};
  ground.cover_a = ground.cover_b = ground.rock_a = ground.rock_b = vec3(kAlbedo);
  ground.snow = ground.beach = vec3(kAlbedo);
  ground.relief = ground.ripple_m = ground.forest_share = 0.0;
  scene.biome.water.enabled = false;
  scene.terrain.kind = scene::TerrainKind::dunes;
  scene.terrain.height_m = scene.terrain.base_m = 0.0;
  // Cells far wider than the dunes leave out even the rounding of their crests.
  scene.terrain.dunes.height_m = 1e-9;
  scene.terrain.dunes.wavelength_m = 1.0;
  scene.terrain.cells = 8;
  scene.terrain.size_m = 100.0;
  scene.terrain.grading = 1.0;
  scene.material(scene::MaterialId::terrain) = {};
}

/// Leaves no light but that of the sun, which stands high in the air of a vacuum.
void light_by_sun(scene::Scene& scene) {
  scene.sun.irradiance = std::numbers::pi;
  scene.sun.color = vec3(1.0f);
  scene.sun.direction = glm::normalize(dvec3(0.31, 1.0, 0.23));
  scene.sky.cumulus.cover = scene.sky.cloud_cover = 0.0;
  scene.air = {0.0, 0.0, vec3(0.0f)};
  scene.haze.visibility_m = 1e12;
  scene.haze.albedo = vec3(0.0f);
  scene.bounces = 0;
  // Plates that reflect nothing leave the ground the light of the sun alone.
  scene::Material& plates = scene.material(scene::MaterialId::rim);
  plates = {};
  plates.albedo = vec3(0.0f);
}

scene::Scene scene_of(scene::Integrator integrator) {
  scene::Scene scene = scene::defaults(scene::BiomeKind::sand, scene::View::outside);
  make_plane(scene);
  scene.balloon.enabled = false;
  scene.vegetation.enabled = false;
  scene.balloon.height_above = scene::HeightReference::sea;
  scene.camera = {};
  scene.camera.position = {0.0, kEyeHeight_m, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.up = {0.0, 0.0, -1.0};
  // Each pixel has the light of its own ray.
  scene.image.filter = scene::Filter::box;
  scene.image.width = kWidth;
  scene.image.height = kHeight;
  scene::set_quality(scene, scene::Quality::draft);
  light_by_sun(scene);
  scene.light = integrator;
  return scene;
}

/// What a ray meets, or nothing if rounding decides.
struct Met {
  double t = 0.0;
  bool is_plate = false;
};

/// Follows a ray from a point to the plane or into the sky. Returns nothing if it passes an edge.
std::optional<Met> follow(const dvec3& from, const dvec3& direction) {
  constexpr double kFar = 1e30;
  Met met{direction.y < 0.0 ? -from.y / direction.y : kFar, false};
  for (const Plate& plate : kPlates) {
    const double t = (plate.centre.y - from.y) / direction.y;
    if (t <= 0.0) continue;
    const dvec3 off = from + t * direction - plate.centre;
    const double inside = plate.half_m - std::max(std::abs(off.x), std::abs(off.z));
    if (std::abs(inside) < kEdge_m) return std::nullopt;
    if (inside > 0.0 && t < met.t) met = {t, true};
  }
  return met;
}

/// Returns the unit vector through the middle of a pixel.
dvec3 direction_of(const scene::Scene& scene, int x, int y) {
  const double step = 2.0 * std::tan(glm::radians(0.5 * scene.camera.fov_y_deg)) / kHeight;
  return glm::normalize(
      dvec3((x + 0.5 - 0.5 * kWidth) * step, -1.0, (y + 0.5 - 0.5 * kHeight) * step));
}

/// The answers that were wrong.
struct Wrong {
  int pixels = 0, objects = 0, distances = 0, lights = 0;

  bool any() const { return objects + distances + lights > 0; }
};

/// Compares a pixel with its closed form.
void check(const scene::Scene& scene, const image::Film& film, int x, int y, Wrong& wrong) {
  const std::size_t i = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
  const dvec3 eye(0.0, kEyeHeight_m, 0.0), ahead = direction_of(scene, x, y);
  const auto met = follow(eye, ahead);
  if (!met) return;
  ++wrong.pixels;
  const auto id = met->is_plate ? kPlateId : scene::ObjectId::terrain;
  if (film.object_id[i] != static_cast<std::uint32_t>(id)) ++wrong.objects;
  // The negations count a NaN as wrong.
  if (!(std::abs(double{film.distance_m[i]} - met->t) <= 1e-4 * met->t)) ++wrong.distances;
  if (met->is_plate) return;
  const auto above = follow(eye + met->t * ahead, scene.sun.direction);
  if (!above) return;
  const double light = above->is_plate ? 0.0 : kAlbedo * scene.sun.direction.y;
  for (int c = 0; c < 3; ++c) {
    if (std::abs(double{film.radiance[i][c]} - light) <= 1e-3 * kAlbedo) continue;
    ++wrong.lights;
    break;
  }
}

std::string key_of(const opencl::Device& device, const SelfTest& test) {
  std::string text;
  for (const auto& [path, source] : opencl::kernel_sources()) {
    text.append(path).append(1, '\n').append(source);
  }
  const int lanes = test.lanes != 0 ? test.lanes : device.lanes;
  return opencl::binary_key(device, text,
                            fmt::format("self-test 1, {} lanes, integrator {}", lanes,
                                        static_cast<int>(test.integrator)));
}

/// Returns what is wrong with a device. Devices that passed with these kernels are not asked again.
std::string new_fault_of(const opencl::Device& device, const SelfTest& test) {
  const auto store = opencl::BinaryStore::of_user();
  const std::string key = key_of(device, test);
  if (store.find(key)) return {};
  std::string fault = fault_of(device, test);
  if (fault.empty()) store.keep(key, "passed");
  return fault;
}

/// Returns the refusal of a device. Kernels from a folder are suspected before the driver, because
/// those of another version may build and yet read other structs than this program writes.
Error refusal(const opencl::Device& device, const std::string& fault) {
  const std::string who =
      fmt::format("the device {} {} with driver {}", device.selector(), device.name, device.driver);
  if (const auto folder = opencl::kernel_folder()) {
    return {ErrorKind::bad_data,
            fmt::format("the kernels in {} (AEROSTAT_KERNEL_DIR) do not fit this program, or {} is "
                        "at fault: {} (name the kernels of this version, unset the variable, or go "
                        "on with --skip-self-test)",
                        folder->string(), who, fault)};
  }
  return {ErrorKind::no_device,
          fmt::format("{} computes wrong results: {} (update its driver, take another device, or "
                      "go on with --skip-self-test)",
                      who, fault)};
}

std::vector<opencl::Device> select_automatic(const SelfTest& test) {
  const opencl::DeviceList list = opencl::list_devices();
  std::optional<Error> first;
  for (const opencl::Device& device : opencl::in_order_of_choice(list)) {
    const bool is_only = list.devices.size() == 1;
    try {
      const std::string fault = new_fault_of(device, test);
      if (fault.empty()) return {device};
      throw refusal(device, fault);
    } catch (const Error& error) {
      if (error.kind() == ErrorKind::interrupted || is_only || opencl::kernel_folder()) throw;
      warn(fmt::format("{}; the next device is taken", error.what()));
      if (!first) first = error;
    }
  }
  if (first) throw *first;
  return opencl::pick(list, "auto");
}

}  // namespace

std::string fault_of(const opencl::Device& device, const SelfTest& test) {
  Options options;
  options.devices = {device};
  options.lanes = test.lanes;
  options.contents = Contents::layers;
  options.more_kinds = {&kPlatesApart, &kPlatesOfOneModel};
  const scene::Scene scene = scene_of(test.integrator);
  Session session(options);
  const image::Film film = session.render(world::resolve(scene), test.stop, test.progress);
  Wrong wrong;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) check(scene, film, x, y, wrong);
  }
  if (!wrong.any()) return {};
  return fmt::format(
      "of {} rays with known answers, {} met the wrong object, {} have a wrong "
      "distance and {} a wrong light",
      wrong.pixels, wrong.objects, wrong.distances, wrong.lights);
}

std::vector<opencl::Device> select_tested(const std::string& selector, const SelfTest& test) {
  if (opencl::is_automatic(selector)) return select_automatic(test);
  auto devices = opencl::select_devices(selector);
  for (const opencl::Device& device : devices) {
    const std::string fault = new_fault_of(device, test);
    if (!fault.empty()) throw refusal(device, fault);
  }
  return devices;
}

}  // namespace aerostat::render
