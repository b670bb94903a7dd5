#include "material/ground.clh"
#include "probe.clh"

/* Stores the noise (broad, fine, rough) and the mix (rock, beach, snow, forest) at points, as
 * planes. */
__kernel void probe_ground(__global const AeroGround* ground, __global const float* points,
                           __global const float* slopes, const float footprint,
                           __global float* noises, __global float* mixes) {
  const Lane3 p = load3(points);
  const GroundNoise noise = ground_noise(ground, p, (lane_float)footprint);
  store3_planes(lane3(noise.broad, noise.fine, noise.rough.value), noises);
  const GroundMix mix = ground_mix(ground, p, LOAD(slopes), LOAD(slopes), &noise);
  store3_planes(lane3(mix.rock, mix.beach, mix.snow), mixes);
  STORE(mix.forest, mixes + 3u * PLANE);
}

/* Stores the albedo of the rock at points. */
__kernel void probe_rock(__global const AeroGround* ground, __global const float* points,
                         const float footprint, __global float* colors) {
  const Lane3 p = load3(points);
  const GroundNoise noise = ground_noise(ground, p, (lane_float)footprint);
  store3_planes(rock_color(ground, p, &noise), colors);
}
