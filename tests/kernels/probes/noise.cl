#include "probe.clh"
#include "solid_noise.clh"

__kernel void probe_perlin(const uint seed, __global const float* x, __global const float* y,
                           __global float* noise) {
  const Noise n = perlin(LOAD(x), LOAD(y), seed);
  store3_planes(lane3(n.value, n.dx, n.dy), noise);
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

/* Values, then gradients as planes. No octaves: one of unit wavelength, unfiltered; else fBm from a
 * wavelength of 8. */
__kernel void probe_solid(const uint seed, const int octaves, const int ridges,
                          __global const float* points, __global const float* footprints,
                          __global float* values, __global float* gradients) {
  const Lane3 p = load3(points);
  SolidNoise n;
  if (octaves == 0) {
    n = solid_noise(p, seed);
  } else if (ridges) {
    n = filtered_solid_fbm(p, seed, 8.0f, octaves, 0.5f, 1, LOAD(footprints));
  } else {
    n = filtered_solid_fbm(p, seed, 8.0f, octaves, 0.5f, 0, LOAD(footprints));
  }
  STORE(n.value, values);
  store3_planes(n.gradient, gradients);
}
