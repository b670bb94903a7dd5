// The lines of flights through the air, and on the ground below them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/smooth_curve.hpp"
#include "core/stop_scope.hpp"
#include "geo/transform.hpp"
#include "model/shapes.hpp"
#include "scatter/surface.hpp"
#include "scene/balloons.hpp"
#include "scene/scene.hpp"
#include "staging/flight_of.hpp"
#include "terrain/real_land.hpp"
#include "world/kinds.hpp"

namespace aerostat::world {
namespace {

using Way = std::vector<dvec3>;

// All were chosen by eye.
constexpr int kSides = 8;
constexpr double kShortestStep_m = 5.0;  // of the points that the line goes through
constexpr double kStep_m = 3.0;          // of the line in the air, which is curved between them
constexpr double kFreeDiameters = 0.8;   // radius around the balloon that is left free
constexpr double kGroundStep_m = 8.0;    // of the line on the ground, which follows its cells
constexpr double kLift_m = 0.4;          // of the line over the ground

/// Returns the way of a flight from take-off to landing, in the coordinates of the local scene.
Way way_of(const scene::FlightTrack& track, const scene::Scene& local, double shortest_m,
           terrain::ReliefCache& reliefs) {
  const auto land = terrain::real_land(local.terrain, reliefs.lands);
  const geo::Place middle = *terrain::middle_point(local.terrain, *land).place;
  const track::Flight flight = staging::flight_of(track, *land).flight;
  Way way;
  for (std::size_t i = flight.takeoff(); i <= flight.landing(); ++i) {
    const track::Position position = flight.position_of(i);
    const dvec2 at = geo::local_point(middle, position.place);
    const double drop = local.terrain.curved ? geo::curvature_drop(glm::length(at)) : 0.0;
    const dvec3 point(local.terrain.center.x + at.x,
                      local.terrain.base_m + position.height_m - drop,
                      local.terrain.center.y + at.y);
    const bool last = i == flight.landing();
    if (way.empty() || glm::distance(way.back(), point) >= (last ? 1e-3 : shortest_m)) {
      way.push_back(point);
    }
  }
  return way;
}

/// Returns a way that goes through the points as a smooth curve, in steps of about a length.
Way curved(const Way& points, double step_m) {
  const SmoothCurve curve(points);
  const std::vector<double>& knots = curve.knots();
  Way way;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double length_m = glm::distance(points[i], points[i + 1]);
    const int steps = std::max(1, static_cast<int>(length_m / step_m));
    for (int k = 0; k < steps; ++k) {
      way.push_back(curve.at(glm::mix(knots[i], knots[i + 1], static_cast<double>(k) / steps)));
    }
  }
  way.push_back(points.back());
  return way;
}

/// Returns the parts of a way that leave a balloon free.
std::vector<Way> parts_beside(const Way& way, const scene::Balloon& balloon) {
  const dvec3 middle = balloon.position + dvec3(0.0, 0.5 * balloon.diameter_m, 0.0);
  std::vector<Way> parts(1);
  for (const dvec3& point : way) {
    if (balloon.enabled && glm::distance(point, middle) < kFreeDiameters * balloon.diameter_m) {
      if (!parts.back().empty()) parts.emplace_back();
    } else {
      parts.back().push_back(point);
    }
  }
  std::erase_if(parts, [](const Way& part) { return part.size() < 2; });
  return parts;
}

/// Returns a level line along a way, laid on the ground.
mesh::TriangleMesh line_on_ground(const Way& way, const scene::TrackLine& line,
                                  const scatter::Surface& ground) {
  mesh::TriangleMesh mesh;
  std::vector<dvec2> points;
  for (std::size_t i = 0; i + 1 < way.size(); ++i) {
    const dvec2 from(way[i].x, way[i].z), to(way[i + 1].x, way[i + 1].z);
    const int steps = std::max(1, static_cast<int>(glm::distance(from, to) / kGroundStep_m));
    for (int k = 0; k < steps; ++k) points.push_back(glm::mix(from, to, double(k) / steps));
  }
  if (!way.empty()) points.emplace_back(way.back().x, way.back().z);
  std::erase_if(points, [&](const dvec2& at) { return !ground.covers(at.x, at.y); });
  if (points.size() < 2) return mesh;
  const auto columns = static_cast<int>(points.size()) - 1;
  model::add_grid(mesh, {.columns = columns, .rows = 1}, [&](int i, int j) {
    const auto at = static_cast<std::size_t>(i);
    const dvec2 before = points[at == 0 ? 0 : at - 1];
    const dvec2 behind = points[std::min(at + 1, points.size() - 1)];
    const dvec2 along = behind - before;
    const double length = std::max(glm::length(along), 1e-6);
    const dvec2 across = dvec2(-along.y, along.x) / length;
    const dvec2 place = points[at] + (j == 0 ? 0.5 : -0.5) * line.width_m * across;
    const scatter::SurfacePoint point = ground.at(place.x, place.y);
    return model::Vertex{dvec3(place.x, point.position.y + kLift_m, place.y), dvec3(point.normal),
                         line.ground_color};
  });
  return mesh;
}

Shape build(const GroupInput& input) {
  Objects objects;
  const scene::Scene& local = input.local;
  if (local.terrain.kind != scene::TerrainKind::elevation) return objects;
  const auto balloons = scene::balloons_of(local);
  for (std::size_t i = 0; i < balloons.size(); ++i) {
    const auto& track = balloons[i]->track;
    if (!track || !track->line) continue;
    stop_if_asked(current_stop());
    const scene::TrackLine& line = *track->line;
    const Way way = way_of(*track, local, std::max(kShortestStep_m, line.width_m), input.reliefs);
    if (way.size() < 2) continue;
    mesh::TriangleMesh mesh;
    for (const Way& part : parts_beside(curved(way, kStep_m), *balloons[i])) {
      model::add_tube(mesh, part, 0.5 * line.width_m, kSides, line.color);
    }
    if (line.on_ground) {
      mesh::append(mesh, line_on_ground(way, line, scatter::Surface(*input.ground)));
    }
    objects.push_back({scene::ObjectId::track, scene::MaterialId::track, std::move(mesh), i});
  }
  return objects;
}

/// Returns the balloons whose flights are shown.
std::vector<scene::Balloon> shown(const scene::Scene& scene) {
  std::vector<scene::Balloon> balloons;
  for (const scene::Balloon* balloon : scene::balloons_of(scene)) {
    if (balloon->track && balloon->track->line) balloons.push_back(*balloon);
  }
  return balloons;
}

bool same(const GroupRequest& now, const GroupRequest& before) {
  return shown(*now.scene) == shown(*before.scene);
}

}  // namespace

const GroupKind kTrackLines{
    .name = "lines of flights", .footing = Footing::on_ground, .build = build, .same = same};

}  // namespace aerostat::world
