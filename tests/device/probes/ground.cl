#include "material/ground.clh"
#include "probe.clh"
#include "surface_of.clh"

/* Stores the noise (broad, fine, rough) at points. */
__kernel void probe_ground_noise(__global const AeroGround* ground, __global const float* points,
                                 const float footprint, __global float* noises) {
  RoughSlope slope;
  const GroundNoise noise = ground_noise(ground, load3(points), (lane_float)footprint, &slope);
  store3_planes(lane3(noise.broad, noise.fine, noise.rough), noises);
}

/* Stores the share of the ground that crowns cover inside of woods. `footprint` is that of clumps
 * alone. */
__kernel void probe_crown_cover(__global const AeroGround* ground, __global const float* points,
                                const float footprint, __global float* covers) {
  RoughSlope slope;
  const Lane3 p = load3(points);
  const GroundNoise noise = ground_noise(ground, p, (lane_float)1.0f, &slope);
  STORE(crown_cover(ground, p, &noise, (lane_float)footprint), covers);
}

/* Stores the mix (rock, beach, snow, forest) as planes, then where the colour of the rock lies, for
 * heights, slopes of the mesh, slopes of its detail and noises. */
__kernel void probe_ground_mix(__global const AeroGround* ground, __global const float* heights,
                               __global const float* slopes, __global const float* details,
                               __global const float* noises, __global float* mixes) {
  const Lane3 values = load3(noises);
  const lane_float height = LOAD(heights);
  const lane_float none = (lane_float)0.0f;
  GroundNoise noise;
  noise.inside.broad = noise.inside.fine = noise.inside.rough = none;
  noise.inside.height = noise.inside.slope = none;
  noise.cover.known = noise.cover.woods = noise.cover.rock = noise.cover.snow = none;
  noise.broad = values.x;
  noise.fine = values.y;
  noise.rough = values.z;
  const GroundMix mix = ground_mix(ground, height, LOAD(slopes), LOAD(details), &noise);
  store3_planes(lane3(mix.rock, mix.beach, mix.snow), mixes);
  STORE(mix.forest, mixes + 3u * PLANE);
  STORE(rock_tone(height, &noise), mixes + 4u * PLANE);
}

/* Writes the share, crop and edge of the field at positions. */
__kernel void probe_field(__global const AeroGround* ground, __global const float* positions,
                          __global const float* slopes, __global const float* noises,
                          __global float* fields) {
  const Lane3 values = load3(noises), p = load3(positions);
  const lane_float none = (lane_float)0.0f;
  GroundNoise noise;
  noise.inside.broad = noise.inside.fine = noise.inside.rough = none;
  noise.inside.height = noise.inside.slope = none;
  noise.cover.known = noise.cover.woods = noise.cover.rock = noise.cover.snow = none;
  noise.broad = values.x;
  noise.fine = values.y;
  noise.rough = values.z;
  const FieldAt field = field_at(ground, p.x, p.z, LOAD(slopes), &noise);
  store3_planes(lane3(field.share, field.crop, field.edge), fields);
}

/* Stores the albedo of ground at points of a slope, and what it makes of light of irradiance pi
 * from one direction. `slope` holds the normal, and then the direction of the light. */
__kernel void probe_lit_ground(__global const AeroGround* ground, __global const float* points,
                               __global const float* slope, const float footprint,
                               __global float* albedos, __global float* lit) {
  Surface surface = blank_surface();
  surface.material.normal = lane3_from(slope);
  surface.point.to_viewer = lane3_from(slope);
  surface.material.diffuse = (lane_float)1.0f;
  const GroundCover cover = {0, 0};
  lay_ground(ground, &cover, -1e6f, load3(points), (lane_float)footprint, (lane_float)0.0f,
             &surface.material);
  const Lobes lobes = phong_lobes(&surface, lane3_from(slope + 3));
  STORE(surface.material.albedo.y, albedos);
  STORE(phong_color(&surface.material, &lobes).y, lit);
}
