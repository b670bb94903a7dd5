#include "geo/transform.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>

#include "core/earth.hpp"
#include "core/error.hpp"
#include "geo/proj_objects.hpp"

namespace aerostat::geo {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Moves all points by an operation of PROJ. Points that it cannot move become NaN.
void move_points(PJ* operation, PJ_DIRECTION direction, std::span<dvec2> points) {
  if (points.empty()) return;
  // PROJ carries a NaN through some projections and takes it for a number in others.
  for (dvec2& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) point = dvec2(HUGE_VAL);
  }
  proj_trans_generic(operation, direction, &points[0].x, sizeof(dvec2), points.size(), &points[0].y,
                     sizeof(dvec2), points.size(), nullptr, 0, 0, nullptr, 0, 0);
  for (dvec2& point : points) {
    if (!std::isfinite(point.x) || !std::isfinite(point.y)) point = dvec2(kNone);
  }
}

/// Returns the turns of 360 degrees taken off that bring a longitude within 180 degrees of another.
double longitude_near(double longitude_deg, double other_deg) {
  return longitude_deg - 360.0 * std::round((longitude_deg - other_deg) / 360.0);
}

void require_place(const Place& place) {
  if (!(std::abs(place.latitude_deg) <= 90.0) || !(std::abs(place.longitude_deg) <= 720.0)) {
    throw Error(ErrorKind::bad_data,
                fmt::format("latitude {} and longitude {} degrees are no place on the Earth",
                            place.latitude_deg, place.longitude_deg));
  }
}

std::string local_frame(const Place& middle) {
  return fmt::format("+proj=tmerc +lat_0={:.17g} +lon_0={:.17g} +k=1 +x_0=0 +y_0=0 ",
                     middle.latitude_deg, longitude_near(middle.longitude_deg, 0.0));
}

/// Returns whether an operation moves the middle of a scene to the middle of its local frame and
/// back, so that its grids and its domain suit the scene.
bool suits(PJ* operation) {
  dvec2 point(0.0);
  move_points(operation, PJ_INV, {&point, 1});
  move_points(operation, PJ_FWD, {&point, 1});
  return std::hypot(point.x, point.y) < 1.0;
}

/// The ways that PROJ knows between two systems around a place, best first.
class Ways {
 public:
  Ways(const ProjContext& context, const PJ* from, const PJ* to, const Place& middle)
      : context_(context.get()),
        from_(from),
        to_(to),
        factory_(proj_create_operation_factory_context(context_, nullptr)) {
    if (!factory_) return;
    constexpr double kAround_deg = 0.01;
    const double lon = longitude_near(middle.longitude_deg, 0.0), lat = middle.latitude_deg;
    proj_operation_factory_context_set_area_of_interest(
        context_, factory_.get(), std::max(lon - kAround_deg, -180.0),
        std::max(lat - kAround_deg, -90.0), std::min(lon + kAround_deg, 180.0),
        std::min(lat + kAround_deg, 90.0));
    proj_operation_factory_context_set_spatial_criterion(
        context_, factory_.get(), PROJ_SPATIAL_CRITERION_PARTIAL_INTERSECTION);
    proj_operation_factory_context_set_grid_availability_use(
        context_, factory_.get(), PROJ_GRID_AVAILABILITY_DISCARD_OPERATION_IF_MISSING_GRID);
  }

  struct Way {
    ProjObject operation;  // null if there is none
    bool guesses = false;  // the datums are taken as equal, because nothing is known between them
  };

  /// Returns the best operation that is valid around the place, or none. `use` says whether it may
  /// go through a third coordinate system.
  Way first(PROJ_INTERMEDIATE_CRS_USE use) const {
    if (!factory_) return {};
    proj_operation_factory_context_set_allow_use_intermediate_crs(context_, factory_.get(), use);
    const std::unique_ptr<PJ_OBJ_LIST, DestroyProj> list(
        proj_create_operations(context_, from_, to_, factory_.get()));
    const int count = list ? proj_list_get_count(list.get()) : 0;
    for (int i = 0; i < count; ++i) {
      const ProjObject plain(proj_list_get(context_, list.get(), i));
      if (!plain) continue;
      ProjObject operation(proj_normalize_for_visualization(context_, plain.get()));
      if (!operation || !suits(operation.get())) continue;
      const bool guesses =
          proj_coordoperation_has_ballpark_transformation(context_, plain.get()) != 0;
      return {std::move(operation), guesses};
    }
    return {};
  }

 private:
  PJ_CONTEXT* context_;
  const PJ* from_;
  const PJ* to_;
  std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, DestroyProj> factory_;
};

/// Returns the best operation around a place. It is one operation for the whole scene, because two
/// of them would differ by metres at a seam.
ProjObject best_operation(const ProjContext& context, const PJ* from, const PJ* to,
                          const Place& middle) {
  const Ways ways(context, from, to, middle);
  Ways::Way direct = ways.first(PROJ_INTERMEDIATE_CRS_USE_NEVER);
  // PROJ searches for a third system for up to a second, and in vain if it does not know this one.
  if ((direct.operation && !direct.guesses) || !context.knows_datum(from)) {
    return std::move(direct.operation);
  }
  Ways::Way through = ways.first(PROJ_INTERMEDIATE_CRS_USE_IF_NO_DIRECT_TRANSFORMATION);
  return std::move(through.operation ? through.operation : direct.operation);
}

}  // namespace

struct Transform::State {
  ProjContext context;
  ProjObject operation;
  bool degrees = false;  // of the system
  double longitude_deg = 0.0;
};

Transform::Transform(const std::string& crs, const Place& middle)
    : state_(std::make_unique<State>()) {
  require_place(middle);
  const ProjContext& context = state_->context;
  const ProjObject whole = context.crs(crs);
  const ProjObject from = context.horizontal(whole, crs);
  const ProjObject to(
      proj_create(context.get(), (local_frame(middle) + "+datum=WGS84 +type=crs").c_str()));
  if (to) state_->operation = best_operation(context, from.get(), to.get(), middle);
  if (!state_->operation) {
    throw Error(ErrorKind::bad_data,
                fmt::format("cannot turn coordinates of \"{}\" into metres around latitude {:.4f}, "
                            "longitude {:.4f} degrees: PROJ knows no way there",
                            shortened(crs), middle.latitude_deg, middle.longitude_deg));
  }
  state_->degrees = proj_degree_output(state_->operation.get(), PJ_INV) != 0;
  state_->longitude_deg = middle.longitude_deg;
}

Transform::~Transform() = default;
Transform::Transform(Transform&&) noexcept = default;
Transform& Transform::operator=(Transform&&) noexcept = default;

void Transform::to_local(std::span<dvec2> points) const {
  move_points(state_->operation.get(), PJ_FWD, points);
  for (dvec2& point : points) point.y = -point.y;
}

void Transform::from_local(std::span<dvec2> points) const {
  for (dvec2& point : points) point.y = -point.y;
  move_points(state_->operation.get(), PJ_INV, points);
  if (!state_->degrees) return;
  for (dvec2& point : points) point.x = longitude_near(point.x, state_->longitude_deg);
}

Place place_of(const std::string& crs, const dvec2& point) {
  const ProjContext context;
  const ProjObject whole = context.crs(crs);
  const ProjObject from = context.horizontal(whole, crs);
  const ProjObject to(proj_create(context.get(), "EPSG:4326"));
  dvec2 moved = point;
  if (const ProjObject plain{
          proj_create_crs_to_crs_from_pj(context.get(), from.get(), to.get(), nullptr, nullptr)}) {
    const ProjObject operation(proj_normalize_for_visualization(context.get(), plain.get()));
    if (operation) move_points(operation.get(), PJ_FWD, {&moved, 1});
    if (operation && !std::isnan(moved.x) && std::abs(moved.y) <= 90.0) {
      return {moved.y, longitude_near(moved.x, 0.0)};
    }
  }
  throw Error(
      ErrorKind::bad_data,
      fmt::format("the point ({}, {}) of the coordinate reference system \"{}\" is no place "
                  "on the Earth",
                  point.x, point.y, shortened(crs)));
}

namespace {

/// Projects places to the local frame of the last middle asked for, by this thread.
PJ* local_projection(const Place& middle) {
  struct Last {
    ProjContext context;
    Place middle;
    ProjObject projection;
  };
  thread_local std::unique_ptr<Last> last;
  require_place(middle);
  if (!last) last = std::make_unique<Last>();
  if (!last->projection || last->middle != middle) {
    last->projection.reset(
        proj_create(last->context.get(), (local_frame(middle) + "+ellps=WGS84").c_str()));
    last->middle = middle;
  }
  if (!last->projection) {
    throw Error(ErrorKind::internal,
                "cannot make the local frame of a scene: " + last->context.complaint());
  }
  return last->projection.get();
}

}  // namespace

dvec2 local_point(const Place& middle, const Place& place) {
  require_place(place);
  constexpr double kRadians = std::numbers::pi / 180.0;
  dvec2 point(place.longitude_deg * kRadians, place.latitude_deg * kRadians);
  move_points(local_projection(middle), PJ_FWD, {&point, 1});
  return {point.x, -point.y};
}

Place place_of_local(const Place& middle, const dvec2& point) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  dvec2 moved(point.x, -point.y);
  move_points(local_projection(middle), PJ_INV, {&moved, 1});
  return {moved.y * kDegrees, longitude_near(moved.x * kDegrees, middle.longitude_deg)};
}

double curvature_drop(double distance_m) {
  return distance_m * distance_m * kEarthFall_per_m;
}

}  // namespace aerostat::geo
