// Further kinds of groups: what a session is given beside those that it knows is built, kept,
// rendered and exported like them.
#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "pictures.hpp"
#include "world/world.hpp"

namespace aerostat::test {
namespace {

constexpr scene::ObjectId kId = scene::ObjectId::rim;

/// A cube whose faces are apart, so that each has normals of its own.
mesh::TriangleMesh cube(const vec3& centre, float half) {
  mesh::TriangleMesh mesh;
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      vec3 normal(0.0f), across(0.0f);
      normal[axis] = side;
      across[(axis + 1) % 3] = half;
      const vec3 up = glm::cross(normal, across);
      const auto base = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [u, v] :
           {std::pair(-1.0f, -1.0f), {1.0f, -1.0f}, {1.0f, 1.0f}, {-1.0f, 1.0f}}) {
        mesh.positions.push_back(centre + half * normal + u * across + v * up);
        mesh.normals.push_back(normal);
      }
      mesh.triangles.emplace_back(base, base + 1, base + 2);
      mesh.triangles.emplace_back(base, base + 2, base + 3);
    }
  }
  return mesh;
}

/// Places around the point that the camera looks at.
std::vector<vec3> places_in(const scene::Scene& local) {
  const scene::Camera& camera = local.camera;
  const dvec3 ahead = glm::normalize(*camera.target - *camera.position);
  const vec3 middle(*camera.position + 12.0 * ahead);
  return {middle, middle + vec3(0.0f, 3.0f, 0.0f), middle + vec3(0.0f, -3.0f, 0.0f)};
}

bool same_camera(const world::GroupRequest& now, const world::GroupRequest& before) {
  return now.scene.eye() == before.scene.eye() && now.scene.target() == before.scene.target();
}

const world::GroupKind kCubes{.name = "cubes",
                              .build = [](const world::GroupInput& input) -> world::Shape {
                                world::Objects objects;
                                for (const vec3& at : places_in(input.local))
                                  objects.push_back({kId, scene::MaterialId::rim, cube(at, 1.0f)});
                                return objects;
                              },
                              .same = same_camera};

/// The same cubes as instances of one model, half as large, on the ground's side of the build.
const world::GroupKind kInstancedCubes{
    .name = "instanced cubes",
    .footing = world::Footing::on_ground,
    .build = [](const world::GroupInput& input) -> world::Shape {
      world::Instances instances;
      instances.models.push_back(
          world::instance_model({{kId, scene::MaterialId::rim, cube(vec3(0.0f), 0.5f)}}));
      for (const vec3& at : places_in(input.local)) {
        scatter::Instance instance;
        instance.position = at;
        instance.scale = 2.0f;
        instances.places.push_back(instance);
      }
      return instances;
    },
    .same = same_camera};

render::Options with(const world::GroupKind& kind) {
  render::Options more = options();
  more.more_kinds = {&kind};
  return more;
}

std::size_t pixels_of(scene::ObjectId id, const image::Film& film) {
  return static_cast<std::size_t>(
      std::count(film.object_id.begin(), film.object_id.end(), static_cast<std::uint32_t>(id)));
}

TEST(Groups, AFifthKindIsRenderedAndKept) {
  auto scene = small_scene("sand-empty");
  render::Session session(with(kCubes));
  const image::Film film = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 2) << "the land and the cubes";
  EXPECT_EQ(session.stats().trees_built, 2);
  EXPECT_GT(pixels_of(kId, film), 100u);
  EXPECT_EQ(pixels_of(kId, shared_session().render(resolved(scene))), 0u);
  scene.sun.irradiance *= 0.5;
  session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 0);
  scene.camera.target->y += 0.5;
  const image::Film turned = session.render(resolved(scene));
  EXPECT_EQ(session.stats().worlds_built, 1);
  EXPECT_TRUE(same_bits(turned, render::Session(with(kCubes)).render(resolved(scene))));
}

TEST(Groups, AFifthKindIsExported) {
  const auto scene = small_scene("sand-empty");
  world::GroupKinds kinds = world::all_kinds();
  kinds.push_back(&kInstancedCubes);
  const world::World world = world::build(resolved(scene), {.kinds = kinds});
  EXPECT_EQ(world::as_triangles(world).size(), 1u) << "the land";
  const world::Objects objects = world::as_triangles(world, world::Placed::included);
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects.back().id, kId);
  EXPECT_EQ(objects.back().mesh.triangles.size(), 3u * 12u);
}

/// Two groups of instances, two of meshes: their models, slots and numbers must not be confused.
TEST(Groups, InstancesOfAFurtherKindStandBesideThePlants) {
  for (const char* name : {"snow-basket", "tropical"}) {
    const auto scene = planted_scene(name);
    render::Options both = with(kCubes), instanced = with(kInstancedCubes);
    const image::Film expected = render::Session(both).render(resolved(scene));
    const image::Film film = render::Session(instanced).render(resolved(scene));
    const auto differ =
        std::inner_product(film.object_id.begin(), film.object_id.end(), expected.object_id.begin(),
                           std::size_t{0}, std::plus<>(), std::not_equal_to<>());
    EXPECT_GT(pixels_of(kId, film), 100u) << name;
    EXPECT_GT(pixels_of(scene::ObjectId::plant, film), 20u) << name;
    // Rounding may decide what a pixel's middle shows at an edge.
    EXPECT_LE(differ, film.object_id.size() / 500) << name;
  }
}

/// Groups that go and come while others stay: the frame must find their arrays again.
TEST(Groups, MayComeAndGoInAnyOrder) {
  auto scene = planted_scene("tropical");
  render::Session session(with(kCubes));
  session.render(resolved(scene));
  for (int step = 0; step < 5; ++step) {
    if (step == 0 || step == 3) scene.balloon.enabled = !scene.balloon.enabled;
    if (step == 1 || step == 3) scene.biome.water.enabled = !scene.biome.water.enabled;
    if (step == 2) scene.balloon.heading_deg += 90.0;
    if (step == 4) scene.vegetation.enabled = false;
    EXPECT_TRUE(same_bits(session.render(resolved(scene)),
                          render::Session(with(kCubes)).render(resolved(scene))))
        << "step " << step;
  }
}

}  // namespace
}  // namespace aerostat::test
