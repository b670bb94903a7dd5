#include "material/water.clh"
#include "probe.clh"

__kernel void probe_fresnel(__global const float* cosines, __global float* reflectance) {
  STORE(fresnel(LOAD(cosines)), reflectance);
}

__kernel void probe_water(__global const AeroScene* scene, __global const float* depths,
                          __global const float* cosines, __global const float* light,
                          __global float* radiance) {
  const Lane3 bed = lane3_from(scene->water.bed);
  const lane_float cosine = LOAD(cosines), zero = (lane_float)0.0f;
  const Lane3 to_viewer = lane3(sqrt(1.0f - cosine * cosine), cosine, zero);
  const Lane3 way = way_below_waves(lane3(zero, (lane_float)1.0f, zero), to_viewer);
  const Lane3 albedo = water_albedo(&scene->water, bed, LOAD(depths), zero, sqrt(dot3(way, way)));
  store3_planes(mul3(albedo, load3(light)), radiance);
}

__kernel void probe_way_below_waves(__global const float* normals, __global const float* to_viewer,
                                    __global float* ways) {
  store3_planes(way_below_waves(load3(normals), load3(to_viewer)), ways);
}

__kernel void probe_waves(__global const AeroScene* scene, __global const float* positions,
                          __global const float* footprints, const float inland,
                          __global float* normals, __global float* roughness) {
  lane_float rough;
  store3_planes(wave_normal(&scene->water, scene->ground.wind, load3(positions), LOAD(footprints),
                            (lane_float)inland, &rough),
                normals);
  STORE(rough, roughness);
}

__kernel void probe_rough_fresnel(__global const float* cosines, const float variance,
                                  __global float* reflectance) {
  STORE(rough_fresnel(LOAD(cosines), (lane_float)variance), reflectance);
}

__kernel void probe_bed(__global const AeroScene* scene, __global const float* positions,
                        __global const float* depths, const float footprint,
                        __global float* albedo) {
  store3_planes(bed_albedo(&scene->water, load3(positions), LOAD(depths), (lane_float)0.0f,
                           (lane_float)footprint),
                albedo);
}

__kernel void probe_foam(__global const float* positions, __global const float* depths,
                         const float footprint, __global float* share) {
  STORE(foam_share(load3(positions), LOAD(depths), (lane_float)footprint), share);
}
