# This script fails unless cmake/HashSources.cmake (SCRIPT) gives equal files in different folders the
# same checksum, and another one to a file that was changed or renamed. It works in FOLDER.
cmake_minimum_required(VERSION 3.25)

# Sets `result` to what the script generates for two files with these names and contents.
function(hash_of result folder first first_text second second_text)
  file(REMOVE_RECURSE "${FOLDER}/${folder}")
  file(WRITE "${FOLDER}/${folder}/${first}" "${first_text}")
  file(WRITE "${FOLDER}/${folder}/${second}" "${second_text}")
  file(WRITE "${FOLDER}/${folder}.txt" "${first};${second}")
  execute_process(COMMAND "${CMAKE_COMMAND}" -D "ROOT=${FOLDER}/${folder}" -D "LIST=${FOLDER}/${folder}.txt"
                          -D "OUTPUT=${FOLDER}/${folder}.cpp" -P "${SCRIPT}" COMMAND_ERROR_IS_FATAL ANY)
  file(READ "${FOLDER}/${folder}.cpp" text)
  set(${result} "${text}" PARENT_SCOPE)
endfunction()

hash_of(here here a.cpp "int a;" b.cpp "int b;")
hash_of(there there a.cpp "int a;" b.cpp "int b;")
hash_of(changed changed a.cpp "int a;" b.cpp "int c;")
hash_of(renamed renamed a.cpp "int a;" c.cpp "int b;")
hash_of(swapped swapped a.cpp "int b;" b.cpp "int a;")
if(NOT here STREQUAL there)
  message(FATAL_ERROR "equal files have different checksums:\n${here}${there}")
endif()
foreach(other changed renamed swapped)
  if(here STREQUAL ${other})
    message(FATAL_ERROR "files that were ${other} have the same checksum:\n${here}")
  endif()
endforeach()
