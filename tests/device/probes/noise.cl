#include "noise/solid_noise.clh"
#include "probe.clh"

__kernel void probe_perlin(const uint seed, __global const float* x, __global const float* y,
                           __global float* noise) {
  const Noise n = perlin(LOAD(x), LOAD(y), seed);
  store3_planes(lane3(n.value, n.dx, n.dy), noise);
}

/* Stores only values: of the plane's noise, of its fBm, of the noise in space and of its folded
 * fBm. */
__kernel void probe_noise_values(const uint seed, const int octaves, __global const float* points,
                                 __global const float* footprints, __global float* values) {
  const Lane3 p = load3(points);
  const lane_float footprint = LOAD(footprints);
  const lane_float plane = perlin_value(p.x, p.y, seed);
  const lane_float fbm = filtered_fbm_value(p.x, p.y, fbm_of(seed, 8.0f, octaves, 0.5f), footprint);
  const lane_float solid = solid_noise_value(p, seed);
  const lane_float solid_fbm =
      filtered_solid_fbm_value(p, solid_fbm_of(seed, 8.0f, octaves, 0.5f, 1), footprint);
  store3_planes(lane3(plane, fbm, solid), values);
  STORE(solid_fbm, values + 3u * PLANE);
}

/* Stores the same values, computed by functions that return slopes too. */
__kernel void probe_noise_with_slopes(const uint seed, const int octaves,
                                      __global const float* points,
                                      __global const float* footprints, __global float* values) {
  const Lane3 p = load3(points);
  const lane_float footprint = LOAD(footprints);
  const Noise plane = perlin(p.x, p.y, seed);
  const Noise fbm = filtered_fbm(p.x, p.y, seed, 8.0f, octaves, 0.5f, footprint);
  const SolidNoise solid = solid_noise(p, seed);
  const SolidNoise solid_fbm =
      filtered_solid_fbm(p, solid_fbm_of(seed, 8.0f, octaves, 0.5f, 1), footprint);
  store3_planes(lane3(plane.value, fbm.value, solid.value), values);
  STORE(solid_fbm.value, values + 3u * PLANE);
}

__kernel void probe_resolved(const float wavelength, __global const float* footprint,
                             __global float* share) {
  STORE(resolved(wavelength, LOAD(footprint)), share);
}

__kernel void probe_fbm(const uint seed, const float wavelength, const int octaves,
                        const float gain, __global const float* x, __global const float* z,
                        __global const float* footprint, __global float* noise) {
  const Noise n = filtered_fbm(LOAD(x), LOAD(z), seed, wavelength, octaves, gain, LOAD(footprint));
  store3_planes(lane3(n.value, n.dx, n.dy), noise);
}

/* Stores values, then gradients as planes. With no octaves, the noise is a single unfiltered one of
 * unit wavelength, else it is fBm from a wavelength of 8. */
__kernel void probe_solid(const uint seed, const int octaves, const int ridges,
                          __global const float* points, __global const float* footprints,
                          __global float* values, __global float* gradients) {
  const Lane3 p = load3(points);
  SolidNoise n;
  if (octaves == 0) {
    n = solid_noise(p, seed);
  } else if (ridges) {
    n = filtered_solid_fbm(p, solid_fbm_of(seed, 8.0f, octaves, 0.5f, 1), LOAD(footprints));
  } else {
    n = filtered_solid_fbm(p, solid_fbm_of(seed, 8.0f, octaves, 0.5f, 0), LOAD(footprints));
  }
  STORE(n.value, values);
  store3_planes(n.gradient, gradients);
}
