#include "pictures.hpp"

#include <cstring>

#include "image/pixel_filter.hpp"
#include "render/scene_cache.hpp"
#include "world/resolve.hpp"

namespace aerostat::test {
namespace {

template <typename T>
std::size_t first_difference(const Array<T>& a, const Array<T>& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::memcmp(&a[i], &b[i], sizeof(T)) != 0) return i;
  }
  return a.size();
}

template <typename T>
testing::AssertionResult same_layer(const char* name, const Array<T>& a, const Array<T>& b,
                                    int width) {
  if (a.size() != b.size()) {
    return testing::AssertionFailure()
           << name << ": " << a.size() << " and " << b.size() << " pixels";
  }
  const std::size_t at = first_difference(a, b);
  if (at == a.size()) return testing::AssertionSuccess();
  const auto row = static_cast<std::size_t>(width);
  return testing::AssertionFailure()
         << name << " differs at pixel " << at % row << ", " << at / row;
}

}  // namespace

namespace {

scene::Scene read_small(const std::string& name, const Size& size) {
  const auto text = [](int value) { return std::to_string(value); };
  const scene::Scene scene =
      scene::read_file(std::string(AEROSTAT_SOURCE_DIR "/scenes/") + name + ".json",
                       {{"/image/width", text(size.width)},
                        {"/image/height", text(size.height)},
                        {"/image/spp", text(size.spp)},
                        {"/terrain/cells", text(size.cells)}});
  return *world::resolve(scene, shared_cache()->reliefs);
}

}  // namespace

scene::Scene small_scene(const std::string& name, const Size& size) {
  scene::Scene scene = read_small(name, size);
  scene.vegetation.enabled = false;
  return scene;
}

scene::Scene planted_scene(const std::string& name, const Size& size) {
  scene::Scene scene = read_small(name, size);
  scene.vegetation.reach_m = 2000.0;
  return scene;
}

const std::vector<opencl::Device>& devices() {
  static const auto& chosen =
      *new std::vector(opencl::select_devices(opencl::effective_selector("")));
  return chosen;
}

const std::shared_ptr<render::SceneCache>& shared_cache() {
  static const auto& cache = *new auto(std::make_shared<render::SceneCache>());
  return cache;
}

render::Options options(int lanes) {
  render::Options chosen;
  chosen.cache = shared_cache();
  chosen.devices = devices();
  chosen.lanes = lanes;
  chosen.use = render::Use::interactive;
  chosen.guides = true;
  return chosen;
}

render::Session& shared_session() {
  static auto& session = *new render::Session(options());
  return session;
}

testing::AssertionResult same_bits(const image::Film& a, const image::Film& b) {
  if (a.width != b.width || a.height != b.height) {
    return testing::AssertionFailure()
           << "sizes " << a.width << " x " << a.height << " and " << b.width << " x " << b.height;
  }
  if (auto r = same_layer("radiance", a.radiance, b.radiance, a.width); !r) return r;
  if (auto r = same_layer("alpha", a.alpha, b.alpha, a.width); !r) return r;
  if (auto r = same_layer("distance", a.distance_m, b.distance_m, a.width); !r) return r;
  if (auto r = same_layer("albedo", a.albedo, b.albedo, a.width); !r) return r;
  if (auto r = same_layer("normal", a.normal_ws, b.normal_ws, a.width); !r) return r;
  if (auto r = same_layer("object", a.object_id, b.object_id, a.width); !r) return r;
  return same_layer("samples", a.samples, b.samples, a.width);
}

image::Film cut(image::Film film, const render::Crop& crop) {
  image::cut_to(film, film.first + glm::ivec2(crop.x0, crop.y0),
                film.first + glm::ivec2(crop.x1, crop.y1));
  return film;
}

}  // namespace aerostat::test
