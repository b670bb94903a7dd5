#include "noise.clh"
#include "probe.clh"

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
