#ifndef AEROSTAT_RULES_GROUND_H
#define AEROSTAT_RULES_GROUND_H

#include "rules/hash.h"
#include "rules/solid_noise.h"
#include "scene_params.h"

/* The rules that decide by height, slope and noise which kind of ground lies where. The device
 * paints the ground by them, and the host places plants by them, so that woods of single trees pass
 * into painted woods. Heights are in metres above the sea, and slopes are cosines (the y of a unit
 * normal). The numbers are chosen by eye. */

AERO_RULES_BEGIN

/* The noise that the rules share. `broad` is for colours and outlines, `fine` for small blotches,
 * and `rough`, which is creased, for the relief of rock. Values are about -0.7 to 0.7. */
typedef struct GroundNoise {
  lane_float broad, fine, rough;
  /* What varies inside of a footprint around the point: the variances of the noise, of the height
   * in metres squared, and of the slope of the ground as it looks from near. All rules return their
   * mean over it. It is 0 for the point itself. */
  struct {
    lane_float broad, fine, rough, height, slope;
  } inside;
  /* What land cover says of the point: the share of ground whose class is known, and of that ground
   * the shares under trees, rock and snow. All are 0 without land cover. */
  struct {
    lane_float known, woods, rock, snow;
  } cover;
} GroundNoise;

/* Returns the height above the sea of a point of the ground. The sea is curved as the ground is. */
AERO_RULE lane_float height_above_sea(AERO_GLOBAL const AeroGround* ground, lane_float x,
                                      lane_float y, lane_float z) {
  return lane_fma(lane_fma(x, x, z * z), (lane_float)ground->fall, y);
}

/* The share of each kind of ground, from 0 to 1. */
typedef struct GroundMix {
  lane_float rock, beach, snow, forest;
} GroundMix;

/* `broad` and `fine` are stretched along the vertical, so that outlines on slopes follow the fall
 * line as gullies do: the noise is taken at this share of the height. */
#define GROUND_NOISE_FLATTENED 0.4f

AERO_RULE SolidFbm broad_fbm(AERO_GLOBAL const AeroGround* ground) {
  return solid_fbm_of(ground->seed + 101u, ground->pattern * 4.0f, 4, 0.6f, 0);
}
AERO_RULE SolidFbm fine_fbm(AERO_GLOBAL const AeroGround* ground) {
  return solid_fbm_of(ground->seed + 211u, ground->pattern * 0.4f, 7, 0.74f, 0);
}
AERO_RULE SolidFbm rough_fbm(AERO_GLOBAL const AeroGround* ground) {
  return solid_fbm_of(ground->seed + 307u, ground->pattern * 0.8f, 8, 0.55f, 1);
}

/* Returns the noise that frays the borders between kinds of ground. */
AERO_RULE lane_float ragged_noise(const GroundNoise* noise) {
  return 0.3f * noise->broad + 1.5f * noise->fine - 0.6f * noise->rough;
}

AERO_RULE lane_float ragged_inside(const GroundNoise* noise) {
  return 0.09f * noise->inside.broad + 2.25f * noise->inside.fine + 0.36f * noise->inside.rough;
}

/* A value with the variance that it has inside of a footprint. */
typedef struct Spread {
  lane_float mean, variance;
} Spread;

AERO_RULE Spread spread_of(lane_float mean, lane_float variance) {
  Spread spread;
  spread.mean = mean;
  spread.variance = variance;
  return spread;
}

/* Returns 0 below `lo` and 1 above `hi`. `ragged` frays the border between them. */
AERO_RULE lane_float frayed_step(float lo, float hi, Spread x, Spread ragged) {
  const float scale = 1.0f / (hi - lo);
  const lane_float t = (x.mean - lo) * scale;
  return spread_step(0.475f, 0.525f, t + 0.34f * ragged.mean,
                     lane_fma(x.variance, (lane_float)(scale * scale), 0.1156f * ragged.variance));
}

/* The share of the height of the upper limit of trees by which `broad` raises and lowers it. */
#define FOREST_TOP_SWAY 0.25f

/* Returns by how many cells of the raster a place is moved before its land cover is looked up, so
 * that borders between classes are ragged lines and no sides of squares. */
AERO_RULE lane_float cover_stray_x(const GroundNoise* noise) {
  return 0.9f * noise->fine + 0.4f * noise->broad;
}
AERO_RULE lane_float cover_stray_z(const GroundNoise* noise) {
  return 0.9f * noise->broad - 0.7f * noise->fine;
}

/* Fills in what the shares of the classes of land cover say. The share of trees among each class
 * was chosen by eye. */
AERO_RULE void note_cover(const lane_float* shares, GroundNoise* noise) {
  const lane_float woods = shares[AERO_COVER_WOODS], shrub = shares[AERO_COVER_SHRUB],
                   meadow = shares[AERO_COVER_MEADOW], crops = shares[AERO_COVER_CROPS],
                   bare = shares[AERO_COVER_BARE], snow = shares[AERO_COVER_SNOW],
                   built_up = shares[AERO_COVER_BUILT_UP], wetland = shares[AERO_COVER_WETLAND];
  noise->cover.known = woods + shrub + meadow + crops + bare + snow + built_up + wetland;
  noise->cover.woods = 0.98f * woods + 0.28f * shrub + 0.08f * meadow + 0.03f * (crops + bare) +
                       0.15f * built_up + 0.2f * wetland;
  noise->cover.rock = bare;
  noise->cover.snow = snow;
}

/* Returns how much woods thin out towards the upper limit of trees, from 0 below it to 1 above
 * it. */
AERO_RULE lane_float forest_thinning(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                     const GroundNoise* noise) {
  return smooth_step((lane_float)(ground->forest_top * 0.6f), (lane_float)ground->forest_top,
                     height + FOREST_TOP_SWAY * ground->forest_top * noise->broad);
}

/* Returns a slowly changing value that is above 0 in the woods and below 0 outside. Woods have
 * clearings. */
AERO_RULE lane_float forest_closeness(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                      const GroundNoise* noise) {
  /* Known woods stand where they are, whatever their height. */
  const lane_float guessed = 1.0f - noise->cover.known;
  const lane_float thin = forest_thinning(ground, height, noise);
  const lane_float woods = ground->forest_share * (1.0f - thin) * guessed + noise->cover.woods;
  const lane_float wish = 2.0f * woods - 1.0f;
  return wish + 0.6f * noise->broad + 0.5f * noise->fine;
}

/* Returns the share of woods where neither slope nor shore forbids them. It does not depend on
 * `rough`. */
AERO_RULE lane_float forest_wished(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                   const GroundNoise* noise) {
  return spread_step(-0.03f, 0.03f, forest_closeness(ground, height, noise),
                     0.36f * noise->inside.broad + 0.25f * noise->inside.fine);
}

/* Returns the share of the shore, which is sand or rock, from 0 above the beach to 1 at the sea and
 * below. */
AERO_RULE lane_float shore_share(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                 const GroundNoise* noise) {
  return 1.0f - spread_step(ground->beach_top - 0.5f, ground->beach_top + 0.5f,
                            height + 2.0f * ragged_noise(noise),
                            noise->inside.height + 4.0f * ragged_inside(noise));
}

/* Returns the share of woods. There are none on bare rock, but trees grow on slopes that are a
 * little too steep for snow. */
AERO_RULE lane_float forest_share(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                  lane_float slope_cos, const GroundNoise* noise) {
  if (!(ground->forest_share > 0.0f) && ground->has_cover == 0u) return (lane_float)0.0f;
  const lane_float hold = frayed_step(ground->rock_cos[1] - 0.06f, ground->rock_cos[0] - 0.06f,
                                      spread_of(slope_cos, (lane_float)0.0f),
                                      spread_of(-ragged_noise(noise), ragged_inside(noise)));
  return forest_wished(ground, height, noise) * hold * (1.0f - shore_share(ground, height, noise));
}

/* Returns the share of snow. `detail_cos` is the slope of the ground as it looks from near, where
 * snow lies on ledges. */
AERO_RULE lane_float snow_share(AERO_GLOBAL const AeroGround* ground, lane_float height,
                                lane_float detail_cos, const GroundNoise* noise) {
  const float half_zone = 0.5f * ground->snow_fuzz;
  const lane_float cold =
      frayed_step(ground->snow_line - half_zone, ground->snow_line + half_zone,
                  spread_of(height, noise->inside.height),
                  spread_of(1.5f * ragged_noise(noise), 2.25f * ragged_inside(noise)));
  /* Wind heaps snow up in some places and blows it away in others. */
  const lane_float swept = 0.9f * noise->broad + 0.22f * noise->fine - 0.2f * noise->rough;
  const lane_float swept_inside =
      0.81f * noise->inside.broad + 0.0484f * noise->inside.fine + 0.04f * noise->inside.rough;
  const lane_float holds =
      frayed_step(ground->snow_cos[1], ground->snow_cos[0],
                  spread_of(detail_cos, noise->inside.slope), spread_of(swept, swept_inside));
  return cold * holds;
}

/* The fields that people have laid out on gentle ground: parcels beside each other with grass left
 * between them. */
typedef struct FieldAt {
  lane_float share; /* of fields, 0 to 1 */
  lane_float crop;  /* a number of the parcel, 0 to 1 */
  lane_float edge;  /* metres to the nearest edge of the parcel */
} FieldAt;

/* The width of the strip of grass along the edge of a field, in metres, and the slopes on which
 * there are fields. */
#define FIELD_VERGE 2.5f
#define FIELD_STEEP_COS 0.965f
#define FIELD_LEVEL_COS 0.985f

/* Returns the field at a place. Parcels lie in rows that are turned by half a radian from north,
 * and each row is shifted against the next. Noise bends them a little. */
AERO_RULE FieldAt field_at(AERO_GLOBAL const AeroGround* ground, lane_float x, lane_float z,
                           lane_float slope_cos, const GroundNoise* noise) {
  const float width = ground->field_width;
  const lane_float bend = 0.12f * width * noise->broad;
  const lane_float across = 0.8775826f * x - 0.4794255f * z + bend;
  const lane_float along = 0.4794255f * x + 0.8775826f * z - bend;
  const lane_float row = lane_floor(across / width);
  const lane_int row_number = lane_to_int(row);
  const lane_float shift =
      lane_from_uint(lattice_hash(ground->seed + 503u, row_number, (lane_int)0) >> 8) *
      5.9604645e-8f;
  const float depth = 1.7f * width;
  const lane_float column = lane_floor(along / depth + shift);
  const lane_uint hash = lattice_hash(ground->seed + 509u, row_number, lane_to_int(column));
  const lane_float u = across - row * width;
  const lane_float v = (along / depth + shift - column) * depth;
  FieldAt field;
  field.crop = lane_from_uint(hash >> 8) * 5.9604645e-8f;
  field.edge = lane_min(lane_min(u, width - u), lane_min(v, depth - v));
  field.share = smooth_step((lane_float)FIELD_STEEP_COS, (lane_float)FIELD_LEVEL_COS, slope_cos) *
                smooth_step((lane_float)-0.25f, (lane_float)-0.05f, noise->broad);
  return field;
}

/* Returns the mix at a height. `slope_cos` is the slope of the mesh, and `detail_cos` that of the
 * ground as it looks from near. The host has no such detail and gives the slope of the mesh for
 * both. */
AERO_RULE GroundMix ground_mix(AERO_GLOBAL const AeroGround* ground, lane_float height,
                               lane_float slope_cos, lane_float detail_cos,
                               const GroundNoise* noise) {
  const Spread ragged = spread_of(ragged_noise(noise), ragged_inside(noise));
  const lane_float shore = shore_share(ground, height, noise);
  GroundMix mix;
  /* Steep shores are rock. */
  mix.beach =
      shore * smooth_step((lane_float)0.9f, (lane_float)0.95f, slope_cos + 0.02f * ragged.mean);
  mix.rock = lane_max(frayed_step(-ground->rock_cos[0], -ground->rock_cos[1],
                                  spread_of(-detail_cos, noise->inside.slope), ragged),
                      shore - mix.beach);
  mix.rock = lane_max(mix.rock, 0.8f * noise->cover.rock);
  mix.snow = lane_max(snow_share(ground, height, detail_cos, noise), noise->cover.snow);
  mix.forest = forest_share(ground, height, slope_cos, noise);
  return mix;
}

/* Trees of a kind stand together: where this sum of the noise is above 0 they are yellower, and
 * elsewhere bluer. */
#define WOODS_WARMTH_OF_BROAD 0.7f
#define WOODS_WARMTH_OF_FINE 0.35f
/* By how much a warmth of 1 raises the red and lowers the blue of leaves, and raises the green of
 * woods that are painted and of single trees. */
#define WARM_RED 0.8f
#define WARM_BLUE 0.5f
#define WARM_PAINTED_GREEN 0.25f
#define WARM_TREE_GREEN 0.35f

/* Returns where the albedo of rock, before it weathers, lies between the ground's rock_a (0) and
 * rock_b (1). */
AERO_RULE lane_float rock_tone(lane_float height, const GroundNoise* noise) {
  /* Beds of rock are bands by height that the noise bends. */
  const lane_float bed = sinpi(height * 0.045f + 2.2f * noise->broad) * 0.5f;
  return clamp01(0.5f + 0.9f * noise->fine - 0.6f * noise->rough + 0.3f * bed);
}

AERO_RULES_END

#endif
