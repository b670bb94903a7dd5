# If Doxygen is installed, the target `reference` writes the API reference to <build>/reference/html.
# It covers the public headers, all of host/ and the device code.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()
set(DOXYGEN_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/reference")
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE "${PROJECT_SOURCE_DIR}/README.md")
set(DOXYGEN_FILE_PATTERNS *.hpp *.h *.clh *.cl *.md)
set(DOXYGEN_EXTENSION_MAPPING clh=C++ cl=C++)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_EXTRACT_STATIC YES)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_QUIET YES)
set(DOXYGEN_SOURCE_BROWSER YES)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_STRIP_FROM_PATH "${PROJECT_SOURCE_DIR}")
set(DOXYGEN_STRIP_FROM_INC_PATH "${PROJECT_SOURCE_DIR}/include" "${PROJECT_SOURCE_DIR}/host"
    "${PROJECT_SOURCE_DIR}/kernels/device" "${PROJECT_SOURCE_DIR}/kernels/shared" "${PROJECT_SOURCE_DIR}/kernels")
doxygen_add_docs(reference
                 "${PROJECT_SOURCE_DIR}/include/aerostat" "${PROJECT_SOURCE_DIR}/host" "${PROJECT_SOURCE_DIR}/kernels"
                 "${PROJECT_SOURCE_DIR}/docs" "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/ARCHITECTURE.md"
                 "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md"
                 WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}"
                 COMMENT "Writing the API reference")
