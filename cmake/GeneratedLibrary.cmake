# The function aerostat_generate_library(target script root comment files...) makes a library of one
# source, which a script generates from the given files below the folder `root`. The library is
# generated again when one of the files changes, appears or disappears. CMake runs the script with
#
#   ROOT     the folder
#   LIST     a file with the list of the files, relative to the folder
#   OUTPUT   the source to be written

function(aerostat_generate_library target script root comment)
  set(files ${ARGN})
  list(SORT files)
  # The list of files is written to a file, so that a removed file changes a dependency too.
  set(list_file "${CMAKE_CURRENT_BINARY_DIR}/${target}_files.txt")
  file(CONFIGURE OUTPUT "${list_file}" CONTENT "${files}" @ONLY)
  set(generated "${CMAKE_CURRENT_BINARY_DIR}/${target}.cpp")
  list(TRANSFORM files PREPEND "${root}/" OUTPUT_VARIABLE dependencies)
  add_custom_command(
    OUTPUT "${generated}"
    COMMAND "${CMAKE_COMMAND}" "-DROOT=${root}" "-DLIST=${list_file}" "-DOUTPUT=${generated}" -P
            "${script}"
    DEPENDS ${dependencies} "${list_file}" "${script}"
    COMMENT "${comment}"
    VERBATIM)
  add_library(${target} STATIC "${generated}")
  target_link_libraries(${target} PRIVATE aerostat_options)
endfunction()
