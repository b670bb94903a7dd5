# `cmake --workflow --preset package` makes three Debian packages in build/package: aerostat (the
# programs), libaerostat0 (the library) and libaerostat-dev (the headers, the files for CMake and
# pkg-config, and the examples).
set(CPACK_PACKAGE_NAME aerostat)
set(CPACK_PACKAGE_VENDOR "aerostat")
set(CPACK_PACKAGE_CONTACT "The maintainers of aerostat <maintainers@aerostat.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray-traced pictures of a hot-air balloon before mountains")
set(CPACK_PACKAGE_DESCRIPTION "Aerostat renders mountain landscapes in a snowy, a tropical or a sandy
biome, with a hot-air balloon seen from outside or from its basket. It traces
rays on OpenCL devices: on the cores of any CPU by PoCL, or on a GPU by its
driver. A few lines of JSON describe a scene, and a window helps to edit it.")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_RESOURCE_FILE_LICENSE "${PROJECT_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PRE_BUILD_SCRIPTS "${PROJECT_SOURCE_DIR}/cmake/PackageStage.cmake")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)  # adds the packages of the linked libraries, such as the OpenCL loader

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL programs library dev)
set(device "pocl-opencl-icd | opencl-icd")
set(library_package "libaerostat${PROJECT_VERSION_MAJOR}")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_NAME aerostat)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_DEPENDS "${device}")
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_RECOMMENDS librsvg2-bin)  # draws the SVG files of artwork
set(CPACK_DEBIAN_LIBRARY_PACKAGE_NAME "${library_package}")
set(CPACK_DEBIAN_LIBRARY_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_DEPENDS "${device}")
set(CPACK_COMPONENT_LIBRARY_DESCRIPTION "ray-traced pictures of landscapes as a library
Programs that link it render scenes of aerostat on OpenCL devices.")
set(CPACK_DEBIAN_DEV_PACKAGE_NAME libaerostat-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "${library_package} (= ${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE})")
set(CPACK_COMPONENT_DEV_DESCRIPTION "headers of the library of aerostat
This package contains what programs need to build against libaerostat.")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# PackageStage.cmake reads these values.
set(CPACK_AEROSTAT_SOURCE_DIR "${PROJECT_SOURCE_DIR}")
set(CPACK_AEROSTAT_DOC_ROOT "${CMAKE_INSTALL_DATADIR}/doc")
set(CPACK_AEROSTAT_LIBRARY_PACKAGE "${library_package}")
set(CPACK_AEROSTAT_MAN_DIR "${CMAKE_INSTALL_MANDIR}")
include(CPack)
