#include "terrain/real_land.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "blend.hpp"
#include "core/error.hpp"
#include "core/simd.hpp"
#include "core/smooth_step.hpp"
#include "cover_water.hpp"
#include "fractal.hpp"
#include "geo/transform.hpp"
#include "gullies.hpp"
#include "relief.hpp"
#include "scene/enum_names.hpp"

namespace aerostat::terrain {
namespace {

// The relief that is added below the resolution of the files. All numbers were chosen by eye.
constexpr double kWidestGully = 2.5;  // of the first octave, in samples
constexpr float kGullyDepth = 0.22f;  // from crest to floor, relative to the width
constexpr float kRoughness =
    0.06f;  // height of noise relative to its longest wave, on steep ground
constexpr int kGullyOctaves = 5, kNoiseOctaves = 9;
// Hills beyond the files: the wavelength of the first octave, the share of the files' relief, and
// the distance over which they reach it.
constexpr double kBeyondFeature_m = 9000.0;
constexpr float kBeyondShare = 0.6f, kBeyondFrom_m = 9000.0f;
// Beds and banks of lakes and rivers: the slope at the shore, and the depth that beds approach far
// from it. Banks around the water hold it over so many widths of the mesh's cells, and then fall.
constexpr float kBedSlope = 0.08f, kDeepest_m = 30.0f;
constexpr float kBankCells = 1.5f, kDamSlope = 1.0f;
constexpr float kSeaDepth_m = 25.0f;  // of large regions without heights that are sea

/// The area around the terrain's square that heights may be asked for, as a share of its side.
constexpr double kReach = 0.6;

class RealLand : public Relief {
 public:
  RealLand(const scene::Terrain& terrain, std::shared_ptr<const land::Land> files,
           const land::Cover* cover)
      : detail_(static_cast<float>(terrain.detail)),
        fall_(scene::ground_fall(terrain)),
        files_(std::move(files)),
        local_(files_->around(middle_point(terrain, *files_), kReach * terrain.size_m)),
        gullies_(kWidestGully * files_->cell_m(), kGullyOctaves, kGullyDepth,
                 terrain.seed ^ 0x27D4EB2Fu),
        noise_(
            make_soft_octaves(2.0 * files_->cell_m(), terrain.seed ^ 0x85EBCA6Bu, kNoiseOctaves)),
        beyond_(make_octaves(scene::Fractal{}, kBeyondFeature_m, terrain.seed ^ 0xC2B2AE35u)),
        beyond_m_(files_->has_sea()
                      ? 0.0f
                      : detail_ * kBeyondShare * (files_->highest_m() - files_->lowest_m())) {
    const bool wanted = terrain.inland_water == scene::InlandWater::automatic;
    if (wanted && cover != nullptr && cover->has_water()) {
      cover_water_.emplace(*cover, *local_, files_->has_sea(), kReach * terrain.size_m);
    }
  }

  void heights(const Points& points, Block& height) const override {
    Slopes ground;
    Block outside;
    const auto count = static_cast<std::size_t>(points.count);
    local_->sample({{points.x.data(), count},
                    {points.z.data(), count},
                    {points.spacing.data(), count},
                    {ground.height.data(), count},
                    {ground.dx.data(), count},
                    {ground.dz.data(), count},
                    {outside.data(), count}});
    if (beyond_m_ > 0.0f) add_hills(points, outside, ground);
    if (detail_ > 0.0f) add_detail(points, ground);
    if (has_water()) shape_shores(points, ground.height);
    for (int i = 0; i < points.count; ++i) {
      height[i] = static_cast<float>(ground.height[i] - drop(points, i));
    }
  }

  bool has_water() const override { return local_->has_water() || cover_water_; }

  void water_levels(const Points& points, Block& level) const override {
    Block shore;
    find_water(points, level, shore);
    for (int i = 0; i < points.count; ++i) {
      level[i] = static_cast<float>(level[i] - drop(points, i));
    }
  }

 private:
  double drop(const Points& points, int i) const {
    const double x = points.x[i], z = points.z[i];
    return fall_ * (x * x + z * z);
  }

  void find_water(const Points& points, Block& level, Block& shore) const {
    const auto count = static_cast<std::size_t>(points.count);
    local_->find_water({{points.x.data(), count},
                        {points.z.data(), count},
                        {points.spacing.data(), count},
                        {level.data(), count},
                        {shore.data(), count}});
    if (!cover_water_) return;
    for (std::size_t i = 0; i < count; ++i) {
      const land::WaterPoint other = cover_water_->at(points.x[i], points.z[i], points.spacing[i]);
      if (std::isnan(other.level_m) || (!std::isnan(level[i]) && shore[i] >= other.shore)) continue;
      level[i] = other.level_m;
      shore[i] = other.shore;
    }
  }

  /// Lays beds under lakes and rivers, which files show as level areas without a depth. Banks meet
  /// the water at its level and hold it where the land around is lower.
  void shape_shores(const Points& points, Block& height) const {
    Block level, shore;
    find_water(points, level, shore);
    const auto cell_m = static_cast<float>(files_->cell_m());
    for (int i = 0; i < points.count; ++i) {
      if (std::isnan(level[i])) continue;
      if (shore[i] > 0.0f) {
        const float share = 1.0f - std::exp(-kBedSlope / kDeepest_m * shore[i]);
        height[i] = level[i] - kDeepest_m * share;
        continue;
      }
      const float inland = -shore[i], width = std::max(cell_m, kBankCells * points.spacing[i]);
      const float above = height[i] - level[i];
      const float bank = above > 0.0f ? above * smooth_step(0.0f, 1.0f, inland / cell_m) : above;
      const float held =
          kBedSlope * std::min(inland, cell_m) - kDamSlope * std::max(inland - width, 0.0f);
      height[i] = level[i] + std::max(bank, held);
    }
  }

  /// Adds roughness and gullies that are finer than the samples of the files. Both follow the
  /// slope, so that plains and lakes stay flat.
  void add_detail(const Points& points, Slopes& ground) const {
    Block rough, strength;
    fbm(noise_, points, rough);
    const float height_m = kRoughness * noise_.front().layer.wavelength_m * detail_;
    for (int i = 0; i < points.count; ++i) {
      const float slope = length_of(ground.dx[i], ground.dz[i]);
      strength[i] = detail_ * smooth_step(0.15f, 0.6f, slope);
      ground.height[i] += height_m * smooth_step(0.03f, 0.8f, slope) * rough[i];
    }
    gullies_.add(points, strength, ground);
  }

  /// Adds hills and ranges beyond the files, so that the horizon is not that of a plain.
  void add_hills(const Points& points, const Block& outside, Slopes& ground) const {
    if (std::all_of(outside.begin(), outside.begin() + points.count,
                    [](float metres) { return metres == 0.0f; })) {
      return;
    }
    Block hills;
    ridged(beyond_, 1.0f, points, hills);
    for (int i = 0; i < points.count; ++i) {
      const float share = smooth_step(0.0f, kBeyondFrom_m, outside[i]);
      ground.height[i] += beyond_m_ * share * (hills[i] - 0.3f);
    }
  }

  float detail_;
  double fall_;  // see scene::ground_fall
  std::shared_ptr<const land::Land> files_;
  std::shared_ptr<const land::LocalLand> local_;
  Gullies gullies_;
  std::vector<Octave> noise_;
  std::vector<Octave> beyond_;
  float beyond_m_;
  std::optional<CoverWater> cover_water_;
};

std::optional<double> metres_of(scene::HeightUnit unit) {
  switch (unit) {
    case scene::HeightUnit::automatic:
      break;
    case scene::HeightUnit::metre:
      return 1.0;
    case scene::HeightUnit::decimetre:
      return 0.1;
    case scene::HeightUnit::centimetre:
      return 0.01;
    case scene::HeightUnit::foot:
      return 0.3048;
    case scene::HeightUnit::us_survey_foot:
      return 1200.0 / 3937.0;
  }
  return std::nullopt;
}

/// Returns the word of a value, or nothing for `automatic`.
template <class Enum>
std::string word_unless_automatic(Enum value) {
  return value == Enum::automatic ? std::string() : scene::detail::word_of(value);
}

}  // namespace

land::LandOptions land_options(const scene::ElevationSource& source) {
  land::LandOptions options;
  options.sources.assign(source.source.begin(), source.source.end());
  elevation::OpenOptions& open = options.open;
  open.crs = source.crs;
  open.metres_per_unit = metres_of(source.unit);
  open.nodata = source.nodata;
  if (source.image_heights_m) {
    open.image_heights_m = {source.image_heights_m->x, source.image_heights_m->y};
  }
  open.cell_m = source.cell_m;
  open.encoding = word_unless_automatic(source.encoding);
  open.variable = source.variable;
  open.raw = {source.raw.width, source.raw.height, word_unless_automatic(source.raw.type),
              source.raw.big_endian, static_cast<std::uint64_t>(source.raw.header_bytes)};
  options.inland_water = source.inland_water == scene::InlandWater::automatic;
  options.sea_depth_m = source.voids == scene::Voids::sea ? kSeaDepth_m : 0.0f;
  return options;
}

std::shared_ptr<const land::Land> real_land(const scene::ElevationSource& source,
                                            RealLandCache& lands) {
  const land::LandOptions options = land_options(source);
  return lands.get(options, [&] { return std::make_shared<const land::Land>(options); });
}

land::LandPoint middle_point(const scene::ElevationSource& source, const land::Land& land) {
  const scene::TerrainPlace& place = source.place;
  if (place.latitude_deg) {
    if (!land.has_place()) {
      throw Error(
          ErrorKind::bad_data,
          "/terrain/place: a latitude and longitude need to know where the source lies; name "
          "its coordinate reference system by /terrain/crs");
    }
    return {geo::Place{*place.latitude_deg, *place.longitude_deg}, {}};
  }
  if (!place.easting) return land.middle();
  const dvec2 own(*place.easting, *place.northing);
  if (!land.has_place()) return {std::nullopt, own};
  return {geo::place_of(land.files()[0].georeference->crs, own), own};
}

std::unique_ptr<Relief> make_real_land(const scene::Terrain& terrain,
                                       std::shared_ptr<const land::Land> files,
                                       const land::Cover* cover) {
  return std::make_unique<RealLand>(terrain, std::move(files), cover);
}

}  // namespace aerostat::terrain
