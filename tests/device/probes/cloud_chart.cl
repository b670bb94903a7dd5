#include "atmosphere/cloud_chart.clh"
#include "probe.clh"

/* Stores how far rays may leap from points in clear air, and 0 for the other points. */
__kernel void probe_clear_way(__global const AeroScene* scene,
                              __global const AeroSkyCell* sky_table,
                              __global const AeroChartWord* cloud_chart,
                              __global const float* positions, __global const float* directions,
                              __global float* ways) {
  const SceneView view = scene_view(scene, sky_table, cloud_chart, 0);
  const Lane3 p = load3(positions), direction = load3(directions);
  const ChartPlace place = chart_place(&view, p.x, p.z);
  const float cell = scene->sky.cumulus.chart.cell;
  const lane_float way =
      clear_way(&place, direction, cell / fabs(direction.x), cell / fabs(direction.z));
  STORE(lane_select(lane_mask(place.clear > 0u), way, (lane_float)0.0f), ways);
}
