# The function aerostat_hash_sources(target) makes a library that contains a checksum of the host
# sources that decide on pixels. Programs read it through host/film/sources_hash.hpp. Only the
# contents of files and their names below the source folder count, so that each machine computes the
# same checksum.
#
# When CMake runs this file as a script (cmake -P), it is the generator of the library's source.

function(aerostat_hash_sources target)
  set(root "${PROJECT_SOURCE_DIR}/host")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${root}" "${root}/*.cpp" "${root}/*.hpp"
       "${root}/*.inc")
  # What these folders make of frames and scenes does not change a frame.
  list(FILTER files EXCLUDE REGEX "^(api|cli|labels|map|viewer)/")
  aerostat_generate_library(${target} "${CMAKE_CURRENT_FUNCTION_LIST_FILE}" "${root}"
                            "Hashing the sources" ${files})
  target_include_directories(${target} PRIVATE "${root}")
endfunction()

function(_aerostat_write_hash)
  file(READ "${LIST}" files)
  set(all "")
  foreach(path IN LISTS files)
    file(SHA256 "${ROOT}/${path}" sum)
    string(APPEND all "${path} ${sum}\n")
  endforeach()
  string(SHA256 hash "${all}")
  string(SUBSTRING "${hash}" 0 16 hash)
  file(WRITE "${OUTPUT}" "// Generated from the sources of the host.
#include \"film/sources_hash.hpp\"

namespace aerostat::film {

std::string_view sources_hash() {
  return \"${hash}\";
}

}  // namespace aerostat::film
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  _aerostat_write_hash()
else()
  include(GeneratedLibrary)
endif()
