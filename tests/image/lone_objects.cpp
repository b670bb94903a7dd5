#include "lone_objects.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "flat_land.hpp"
#include "pack/pack_scene.hpp"
#include "pack/sky_importance.hpp"
#include "render/device_worker.hpp"

namespace aerostat::test {
namespace {

const world::GroupKind kLone{.name = "lone objects"};

/// Returns light of the same radiance from everywhere, without sun and air.
pack::PackedScene even_light(const scene::Scene& scene, float sky) {
  pack::PackedScene packed = pack::pack_scene(resolved(scene));
  AeroAir& air = packed.numbers.air;
  const AeroSkyCell cell{{sky, sky, sky}, {0.0f, 0.0f, 0.0f}};
  std::fill(packed.sky_table.begin(), packed.sky_table.end(), cell);
  for (auto& term : air.ambient) std::fill(std::begin(term), std::end(term), 0.0f);
  for (int c = 0; c < 3; ++c) {
    air.ambient[0][c] = sky;
    packed.numbers.sky.sun_irradiance[c] = 1.0f;
    air.molecules[c] = air.haze_scattering[c] = air.haze_extinction[c] = 0.0f;
  }
  // The sun stays below the horizon of all that is in sight.
  air.sun_heights[0] = 1e8f;
  air.sun_heights[1] = 2e8f;
  packed.numbers.sky.sun_chord = 0.0f;
  if (packed.sky_importance) {
    packed.sky_importance = pack::sky_importance(packed.numbers, packed.sky_table);
  }
  return packed;
}

}  // namespace

mesh::TriangleMesh ball(const vec3& centre, float radius) {
  constexpr std::uint32_t kRows = 24, kColumns = 48;
  mesh::TriangleMesh mesh;
  for (std::uint32_t row = 0; row <= kRows; ++row) {
    for (std::uint32_t column = 0; column <= kColumns; ++column) {
      const float rise = kPi * (0.5f - static_cast<float>(row) / kRows);
      const vec3 n =
          direction_from_angles(2.0f * kPi * static_cast<float>(column) / kColumns, rise);
      mesh.positions.push_back(centre + radius * n);
      mesh.normals.push_back(n);
      mesh.colors.emplace_back(1.0f);
      if (row == kRows || column == kColumns) continue;
      const std::uint32_t i = row * (kColumns + 1) + column;
      if (row > 0) mesh.triangles.emplace_back(i, i + 1, i + kColumns + 2);
      if (row + 1 < kRows) mesh.triangles.emplace_back(i, i + kColumns + 2, i + kColumns + 1);
    }
  }
  return mesh;
}

world::Object plain_object(mesh::TriangleMesh mesh) {
  return {scene::ObjectId::envelope, scene::MaterialId::envelope, std::move(mesh)};
}

scene::Scene lone_scene() {
  scene::Scene scene = flat_land();
  scene.terrain.base_m = -5000.0;
  scene.camera.position = {0.0, 0.0, 6.0};
  scene.camera.up = {0.0, 1.0, 0.0};
  scene.image.width = kLoneWidth;
  scene.image.height = kLoneHeight;
  scene.image.spp = 16;
  scene.sky.ambient_occlusion = true;
  scene.sky.cloud_cover = 0.0;
  scene.sun.direction = glm::normalize(dvec3(0.3, 0.5, 0.4));
  scene.material(scene::MaterialId::envelope) = {};
  return scene;
}

image::Film lone_film(world::Objects objects, const scene::Scene& scene, float sky,
                      std::uint32_t plain_paths) {
  world::World world = world::build(resolved(scene));
  world.groups.push_back(world::make_group(kLone, std::move(objects)));
  const auto [tree, arrays] =
      render::only_frame(render::pack_world(std::move(world), nullptr, render::Meshes::release));

  render::Options options;
  options.guides = true;
  render::DeviceWorker worker(devices().front(), options);
  worker.begin_programs(scene.light);
  while (!worker.await_programs(std::chrono::milliseconds(100))) continue;
  worker.set_geometry(tree, arrays, {});
  const render::Crop all{0, 0, scene.image.width, scene.image.height};
  pack::PackedScene packed = even_light(scene, sky);
  packed.numbers.plain_paths = plain_paths;
  worker.begin_frame(packed, all.pixels());
  worker.begin_film(all, render::Layers::all);
  render::RowQueue queue(0, all.y1, 1);
  for (int sample = 0; sample < scene.image.spp; ++sample) {
    queue.begin_pass();
    worker.trace({pack::pack_frame(resolved(scene)), all, sample, 1, 0}, queue, 0,
                 [&](int) -> const render::DeviceFilm& { return worker.film(); }, {});
  }
  const render::FilmRows rows{0, all.y1, &worker.film()};
  return render::read_film(std::span(&rows, 1), {all.x1, all.y1, all, all}).film;
}

}  // namespace aerostat::test
