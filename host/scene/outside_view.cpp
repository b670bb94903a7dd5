#include "scene/outside_view.hpp"

#include <cmath>
#include <numbers>

#include "scene/enum_names.hpp"
#include "scene/json_print.hpp"
#include "scene/scene.hpp"
#include "scene/view_axes.hpp"

namespace aerostat::scene {
namespace {

using detail::OrderedJson;

constexpr double kDegrees = 180.0 / std::numbers::pi;

OrderedJson triple(const dvec3& v) {
  return OrderedJson::array({v.x, v.y, v.z});
}

OrderedJson camera_of(const ResolvedScene& scene, const dvec3& origin) {
  const Camera& camera = scene->camera;
  const Image& image = scene->image;
  const ViewAxes axes = view_axes(camera);
  const double aspect = static_cast<double>(image.width) / image.height;
  const double tangent = std::tan(0.5 * camera.fov_y_deg / kDegrees);
  OrderedJson json = {{"lens", detail::enum_names<Lens>()[static_cast<std::size_t>(camera.lens)]},
                      {"position", triple(scene.eye() - origin)},
                      {"right", triple(axes.right)},
                      {"up", triple(axes.up)},
                      {"forward", triple(axes.forward)},
                      {"width", image.width},
                      {"height", image.height}};
  switch (camera.lens) {
    case Lens::pinhole:
    case Lens::thin_lens:
      json["fov_x_deg"] = 2.0 * kDegrees * std::atan(tangent * aspect);
      json["fov_y_deg"] = camera.fov_y_deg;
      break;
    case Lens::orthographic:
      json["view_width_m"] = camera.view_height_m * aspect;
      json["view_height_m"] = camera.view_height_m;
      break;
    case Lens::panorama:
      break;
  }
  return json;
}

OrderedJson sun_of(const Sun& sun) {
  const dvec3 irradiance = dvec3(sun.color) * sun.irradiance;
  const double sine = std::sin(0.5 * sun.diameter_deg / kDegrees);
  return {{"direction", triple(glm::normalize(sun.direction))},
          {"diameter_deg", sun.diameter_deg},
          {"irradiance", triple(irradiance)},
          {"radiance", triple(irradiance / (std::numbers::pi * sine * sine))}};
}

}  // namespace

std::string outside_view_text(const ResolvedScene& scene, const dvec3& origin) {
  OrderedJson json = {{"origin", triple(origin)},
                      {"camera", camera_of(scene, origin)},
                      {"sun", sun_of(scene->sun)}};
  if (scene->sky.radiance) json["sky"] = {{"radiance", triple(dvec3(*scene->sky.radiance))}};
  return detail::print_json(json);
}

}  // namespace aerostat::scene
