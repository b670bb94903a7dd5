#pragma once

/// These macros compile one loop for several vector widths, one of which is chosen at run time. A
/// loop marked AEROSTAT_INLINE is called by three functions: a plain one and two marked
/// AEROSTAT_FOR_AVX2 and AEROSTAT_FOR_AVX512. The compiler may not contract multiplications and
/// additions, so that all three give the same bits. All three are plain on processors other than
/// x86-64.
#if defined(__GNUC__)
#define AEROSTAT_INLINE inline __attribute__((always_inline))
#define AEROSTAT_INLINE_LAMBDA __attribute__((always_inline))
#else
#define AEROSTAT_INLINE inline
#define AEROSTAT_INLINE_LAMBDA
#endif

#if defined(__x86_64__) && defined(__GNUC__)
#define AEROSTAT_FOR_AVX2 __attribute__((target("avx2")))
#if defined(__clang__)  // Clang drops the attribute for an unknown word
#define AEROSTAT_FOR_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))
#else
#define AEROSTAT_FOR_AVX512 \
  __attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#endif
#else
#define AEROSTAT_FOR_AVX2
#define AEROSTAT_FOR_AVX512
#endif

namespace aerostat {

/// Returns the loop for the widest vectors that this processor has, out of three that do the
/// same.
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

namespace simd {

template <typename Work>
void run_plain(const Work& work) {
  work();
}
template <typename Work>
AEROSTAT_FOR_AVX2 void run_avx2(const Work& work) {
  work();
}
template <typename Work>
AEROSTAT_FOR_AVX512 void run_avx512(const Work& work) {
  work();
}

}  // namespace simd

/// Runs `work()`, compiled for the widest vectors that this processor has. `work` is a lambda
/// marked AEROSTAT_INLINE_LAMBDA:
///   in_vectors([&]() AEROSTAT_INLINE_LAMBDA { ... })
template <typename Work>
void in_vectors(const Work& work) {
  static void (*const run)(const Work&) =
      widest(simd::run_plain<Work>, simd::run_avx2<Work>, simd::run_avx512<Work>);
  run(work);
}

}  // namespace aerostat
