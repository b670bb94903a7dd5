#include "material/ground.clh"
#include "probe.clh"

/* Stores the noise (broad, fine, rough) at points. */
__kernel void probe_ground_noise(__global const AeroGround* ground, __global const float* points,
                                 const float footprint, __global float* noises) {
  Lane3 gradient;
  const GroundNoise noise = ground_noise(ground, load3(points), (lane_float)footprint, &gradient);
  store3_planes(lane3(noise.broad, noise.fine, noise.rough), noises);
}

/* Stores the mix (rock, beach, snow, forest) as planes, then where the colour of the rock lies, for
 * heights, slopes of the mesh, slopes of its detail and noises. */
__kernel void probe_ground_mix(__global const AeroGround* ground, __global const float* heights,
                               __global const float* slopes, __global const float* details,
                               __global const float* noises, __global float* mixes) {
  const Lane3 values = load3(noises);
  const lane_float height = LOAD(heights);
  GroundNoise noise;
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
  GroundNoise noise;
  noise.broad = values.x;
  noise.fine = values.y;
  noise.rough = values.z;
  const FieldAt field = field_at(ground, p.x, p.z, LOAD(slopes), &noise);
  store3_planes(lane3(field.share, field.crop, field.edge), fields);
}
