#include "probe.clh"

__kernel void probe_compare(__global const float* a, __global const float* b, __global int* less,
                            __global float* chosen, __global float* least, __global float* most,
                            __global uint* chosen_uint) {
  const lane_float x = LOAD(a), y = LOAD(b);
  const lane_int mask = lane_mask(x < y);
  STORE(mask, less);
  STORE(lane_select(mask, x, y), chosen);
  STORE(lane_min(x, y), least);
  STORE(lane_max(x, y), most);
  STORE(lane_select(mask, LANE_INDEX, (lane_uint)99u), chosen_uint);
}

/* Stores one word per work-item: the packet's mask as bits, any, and all. */
__kernel void probe_bits(__global const int* masks, __global uint* bits, __global int* any_all) {
  const lane_int mask = LOAD(masks);
  const size_t i = get_global_id(0);
  bits[i] = lane_bits(mask);
  any_all[2 * i] = lane_any(mask);
  any_all[2 * i + 1] = lane_all(mask);
}

/* Tests lane_bits8, which serves the children of a node at every width. */
__kernel void probe_bits8(__global const int* masks, __global uint* bits) {
  bits[get_global_id(0)] = lane_bits8(vload8(get_global_id(0), masks));
}

__kernel void probe_reduce(__global const float* a, __global float* least, __global float* most) {
  least[get_global_id(0)] = lane_reduce_min(LOAD(a));
  most[get_global_id(0)] = lane_reduce_max(LOAD(a));
}

__kernel void probe_gather(__global const float* numbers, __global const uint* words,
                           __global const uint* index, __global float* number,
                           __global uint* word) {
  const lane_uint i = LOAD(index);
  STORE(lane_gather(numbers, i), number);
  STORE(lane_gather_uint(words, i), word);
}

__kernel void probe_convert(__global const float* numbers, __global int* ints, __global uint* bits,
                            __global float* back, __global uint* index, __global float* array) {
  const lane_float x = LOAD(numbers);
  const lane_int whole = lane_to_int(x);
  STORE(whole, ints);
  STORE(lane_as_uint(x), bits);
  STORE(lane_from_int(whole) + lane_from_uint(lane_to_uint(fabs(x))) +
            lane_as_float(lane_as_int((lane_float)0.25f)),
        back);
  STORE(LANE_INDEX, index);
  LaneArray as_array;
  as_array.lanes = x;
  for (int i = 0; i < LANES; ++i) array[get_global_id(0) * LANES + i] = as_array.at[i];
}

/* Computes a b - c d in the form in which the triangle test writes it. */
__kernel void probe_difference(__global const float* a, __global const float* b,
                               __global const float* c, __global const float* d,
                               __global float* difference) {
  const lane_float p = LOAD(a), q = LOAD(b), r = LOAD(c), s = LOAD(d);
  STORE(p * q - r * s, difference);
}
