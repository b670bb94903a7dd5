#include "probe.clh"
#include "surface_of.clh"

/* What a material makes of light from given directions, and their densities. */
__kernel void probe_evaluate(__global const float* coefficients, __global const float* normals,
                             __global const float* viewers, __global const float* directions,
                             __global float* values, __global float* densities) {
  const Surface surface = surface_of(coefficients, load3(normals), load3(viewers));
  const Lane3 to_light = load3(directions);
  store3_planes(evaluate_material(&surface, to_light), values);
  STORE(material_pdf(&surface, to_light), densities);
}

/* The directions, weights and densities that it chooses by three numbers each. */
__kernel void probe_sample(__global const float* coefficients, __global const float* normals,
                           __global const float* viewers, __global const float* numbers,
                           __global float* directions, __global float* weights,
                           __global float* densities) {
  const Surface surface = surface_of(coefficients, load3(normals), load3(viewers));
  const Lane3 chosen = load3(numbers);
  SampleNumbers at;
  at.u = chosen.x;
  at.v = chosen.y;
  at.w = chosen.z;
  const MaterialSample sample = sample_material(&surface, &at);
  store3_planes(sample.to_light, directions);
  store3_planes(sample.weight, weights);
  STORE(sample.pdf, densities);
}
