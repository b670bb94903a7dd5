# `cmake --workflow --preset package` makes build/package/aerostat_VERSION_ARCHITECTURE.deb.
set(CPACK_PACKAGE_NAME aerostat)
set(CPACK_PACKAGE_VENDOR "aerostat")
set(CPACK_PACKAGE_CONTACT "The maintainers of aerostat <maintainers@aerostat.example>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "ray-traced pictures of a hot-air balloon before mountains")
set(CPACK_PACKAGE_DESCRIPTION "Aerostat renders mountain landscapes in a snowy, a tropical or a sandy
biome, with a hot-air balloon seen from outside or from its basket. It traces
rays on OpenCL devices: on the cores of any CPU by PoCL, or on a GPU by its
driver. A few lines of JSON describe a scene; a window sets it up by eye.")
set(CPACK_PACKAGE_CHECKSUM SHA256)
set(CPACK_RESOURCE_FILE_LICENSE "${CMAKE_SOURCE_DIR}/LICENSE")
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_PRE_BUILD_SCRIPTS "${CMAKE_SOURCE_DIR}/cmake/PackageStage.cmake")

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON) # the libraries; OpenCL's loader is among them
set(CPACK_DEBIAN_PACKAGE_DEPENDS "pocl-opencl-icd | opencl-icd") # a device
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)

# Read by PackageStage.cmake.
set(CPACK_AEROSTAT_SOURCE_DIR "${CMAKE_SOURCE_DIR}")
set(CPACK_AEROSTAT_DOC_DIR "${CMAKE_INSTALL_DOCDIR}")
set(CPACK_AEROSTAT_MAN_DIR "${CMAKE_INSTALL_MANDIR}")
include(CPack)
