# The target `demo` builds aerostat and renders one scene, to show that the program works.
add_custom_target(demo
  COMMAND "${CMAKE_COMMAND}" -E make_directory out
  COMMAND aerostat render scenes/snow.json -o out/snow.png
  COMMAND "${CMAKE_COMMAND}" -E echo "Rendered out/snow.png"
  WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
  USES_TERMINAL
  VERBATIM)
