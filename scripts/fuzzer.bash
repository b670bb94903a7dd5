# Scripts that run libFuzzer read this file in the folder of the project.

# A compiler may be there without libFuzzer, which Debian has in libclang-rt-VERSION-dev.
has_fuzzer() {
  printf 'extern "C" int LLVMFuzzerTestOneInput(const char*, unsigned long) { return 0; }' |
    "$1" -fsanitize=fuzzer -x c++ - -o /dev/null 2>/dev/null
}

# build_fuzzer SCRIPT TARGET builds a program with libFuzzer and the sanitizers, and sets `build` to the
# folder that it is in. CLANGXX names a compiler; without it, the first of Debian's that has libFuzzer is
# taken.
build_fuzzer() {
  local compiler=${CLANGXX:-} version
  for version in 14 15 16 19; do
    [ -n "$compiler" ] || ! has_fuzzer "clang++-$version" || compiler=clang++-$version
  done
  [ -n "$compiler" ] || { echo "$1: no Clang with libFuzzer was found; install" \
    "libclang-rt-14-dev or libfuzzer-15-dev" >&2; exit 69; }

  build=build/fuzz-${compiler##*/}
  cmake -S . -B "$build" -G Ninja -DCMAKE_CXX_COMPILER="$compiler" -DCMAKE_BUILD_TYPE=RelWithDebInfo \
    -DAEROSTAT_SANITIZE=ON -DAEROSTAT_FUZZERS=ON -DAEROSTAT_BENCH=OFF -DAEROSTAT_VIEWER=OFF \
    -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON >/dev/null
  cmake --build "$build" --target "$2"
}
