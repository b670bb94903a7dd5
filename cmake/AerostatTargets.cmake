# This file holds what all targets of the project share: the language level, warnings, sanitizers
# and the function by which each host folder declares its library.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

option(AEROSTAT_WERROR "Treat warnings as errors" OFF)
# Large headers are precompiled. ccache does not cache a file that reads a precompiled header, so a build
# with ccache goes without them.
if(NOT DEFINED CMAKE_DISABLE_PRECOMPILE_HEADERS AND CMAKE_CXX_COMPILER_LAUNCHER MATCHES "ccache")
  set(CMAKE_DISABLE_PRECOMPILE_HEADERS ON)
endif()

option(AEROSTAT_SANITIZE "Build with AddressSanitizer and UndefinedBehaviorSanitizer" OFF)

add_library(aerostat_options INTERFACE)
target_include_directories(aerostat_options INTERFACE "${PROJECT_SOURCE_DIR}/host"
                           "${PROJECT_SOURCE_DIR}/include")
# Host arithmetic must give the same bits at every optimisation level. Therefore multiplications
# and additions are not fused.
target_compile_options(aerostat_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion
                       -Wno-sign-conversion -Wno-psabi -ffp-contract=off
                       $<$<BOOL:${AEROSTAT_WERROR}>:-Werror>)
# These options are for folders that spend their time in loops over arrays. Compilers vectorise
# square roots and selections only if the code needs neither errno nor floating-point exceptions.
# The options do not change values.
set(AEROSTAT_LOOP_OPTIONS -fno-math-errno -fno-trapping-math)
if(AEROSTAT_SANITIZE)
  # With instrumented standard headers, GCC 12 warns of uninitialised members that do not exist.
  target_compile_options(aerostat_options INTERFACE -fsanitize=address,undefined
                         -fno-omit-frame-pointer -fno-sanitize-recover=undefined
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(aerostat_options INTERFACE -fsanitize=address,undefined)
endif()
option(AEROSTAT_SANITIZE_THREADS "Build with ThreadSanitizer" OFF)
if(AEROSTAT_SANITIZE_THREADS)
  target_compile_options(aerostat_options INTERFACE -fsanitize=thread -fno-omit-frame-pointer
                         $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized -Wno-tsan>)
  target_link_options(aerostat_options INTERFACE -fsanitize=thread)
endif()
option(AEROSTAT_FUZZERS "Build programs of libFuzzer, which needs Clang" OFF)
if(AEROSTAT_FUZZERS)
  target_compile_options(aerostat_options INTERFACE -fsanitize=fuzzer-no-link)
endif()

# This function declares the library of one host folder:
#   aerostat_library(bvh SOURCES a.cpp b.cpp LINKS aerostat::core TBB::tbb PRIVATE_LINKS ...)
# The folder may include only headers of the libraries that it links. LOOPS adds the options for
# loops. PRECOMPILED names a precompiled header for this library alone. A library with neither shares
# the precompiled header of core, because a shared one requires the same compile options.
function(aerostat_library name)
  cmake_parse_arguments(ARG "LOOPS" "PRECOMPILED" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(aerostat_${name} STATIC ${ARG_SOURCES})
  add_library(aerostat::${name} ALIAS aerostat_${name})
  target_link_libraries(aerostat_${name} PUBLIC aerostat_options ${ARG_LINKS}
                        PRIVATE ${ARG_PRIVATE_LINKS})
  if(ARG_LOOPS)
    target_compile_options(aerostat_${name} PRIVATE ${AEROSTAT_LOOP_OPTIONS})
  elseif(ARG_PRECOMPILED)
    target_precompile_headers(aerostat_${name} PRIVATE ${ARG_PRECOMPILED})
  else()
    target_precompile_headers(aerostat_${name} REUSE_FROM aerostat_core)
  endif()
endfunction()
