# The function aerostat_embed_kernels(target) makes a library that contains every kernel file below
# the current folder. Programs read it through host/opencl/embedded.hpp.
#
# When CMake runs this file as a script (cmake -P), it is the generator of the library's source.

function(aerostat_embed_kernels target)
  set(root "${CMAKE_CURRENT_SOURCE_DIR}")
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${root}" "${root}/shared/*.h" "${root}/rules/*.h"
       "${root}/device/*.clh" "${root}/*.cl")
  aerostat_generate_library(${target} "${CMAKE_CURRENT_FUNCTION_LIST_FILE}" "${root}"
                            "Embedding the kernels" ${files})
endfunction()

# Sets `array` to the definition of an array of the file's bytes, and `entry` to the file's line of
# the table. Arrays of bytes are used because compilers limit the length of string literals.
function(_aerostat_embed_file index path)
  file(READ "${ROOT}/${path}" hex HEX)
  string(LENGTH "${hex}" digits)
  math(EXPR size "${digits} / 2")
  string(REGEX REPLACE "(................................)" "\\1\n" hex "${hex}")
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  set(array "const unsigned char file_${index}[] = {\n${bytes}0};\n" PARENT_SCOPE)
  set(entry "    {\"${path}\", {reinterpret_cast<const char*>(file_${index}), ${size}}},\n"
      PARENT_SCOPE)
endfunction()

function(_aerostat_write_embedded)
  file(READ "${LIST}" files)
  set(arrays "")
  set(table "")
  set(index 0)
  foreach(path IN LISTS files)
    _aerostat_embed_file(${index} "${path}")
    string(APPEND arrays "${array}")
    string(APPEND table "${entry}")
    math(EXPR index "${index} + 1")
  endforeach()
  file(WRITE "${OUTPUT}" "// Generated from the folder of kernels.
#include \"opencl/embedded.hpp\"

#include <array>

namespace aerostat::opencl {
namespace {

${arrays}
}  // namespace

std::span<const EmbeddedFile> embedded_files() {
  static const std::array<EmbeddedFile, ${index}> files{{
${table}  }};
  return files;
}

}  // namespace aerostat::opencl
")
endfunction()

if(CMAKE_SCRIPT_MODE_FILE STREQUAL CMAKE_CURRENT_LIST_FILE)
  _aerostat_write_embedded()
else()
  include(GeneratedLibrary)
endif()
