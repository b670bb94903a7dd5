#pragma once

/// One loop compiled for several widths of vectors, chosen at run time: a loop marked
/// AEROSTAT_INLINE is called by three functions, a plain one and two marked AEROSTAT_FOR_AVX2 and
/// AEROSTAT_FOR_AVX512. The compiler may not contract multiplications and additions, so that all
/// give the same bits. On other processors than x86-64 all three are plain.
#if defined(__GNUC__)
#define AEROSTAT_INLINE inline __attribute__((always_inline))
#else
#define AEROSTAT_INLINE inline
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define AEROSTAT_FOR_AVX2 __attribute__((target("avx2")))
#define AEROSTAT_FOR_AVX512 \
  __attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#else
#define AEROSTAT_FOR_AVX2
#define AEROSTAT_FOR_AVX512
#endif

namespace aerostat {

/// Of three that do the same, the one for the widest vectors that this processor has.
template <typename Loop>
Loop widest([[maybe_unused]] Loop plain, [[maybe_unused]] Loop avx2, [[maybe_unused]] Loop avx512) {
#if defined(__x86_64__) && defined(__GNUC__)
  if (__builtin_cpu_supports("avx512dq") != 0 && __builtin_cpu_supports("avx512vl") != 0) {
    return avx512;
  }
  if (__builtin_cpu_supports("avx2") != 0) return avx2;
#endif
  return plain;
}

}  // namespace aerostat
