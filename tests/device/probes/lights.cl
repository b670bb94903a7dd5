#include "light/lights.clh"
#include "probe.clh"

/* Samples of light `light` at points of a plane: direction, distance, strength and density. */
__kernel void probe_light(__global const AeroScene* scene, __global const AeroSkyCell* sky_table,
                          __global const AeroChartWord* cloud_chart, const uint light,
                          __global const float* positions, __global const float* normals,
                          __global const float* numbers, __global float* directions,
                          __global float* distances, __global float* strengths,
                          __global float* densities) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  const Lane3 chosen = load3(numbers);
  SampleNumbers at;
  at.u = chosen.x;
  at.v = chosen.y;
  at.w = chosen.z;
  const LightSample sample = sample_light(&view, light, load3(positions), load3(normals), &at);
  store3_planes(sample.to_light, directions);
  STORE(sample.distance, distances);
  store3_planes(sample.strength, strengths);
  STORE(sample.pdf, densities);
}
