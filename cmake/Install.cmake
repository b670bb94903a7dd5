# `cmake --install` installs three components: `programs` with everything that they need, `library`
# (libaerostat) and `dev` (the headers and the files that find_package and pkg-config read). This file
# must be included after the folders of host/, which define the targets.
include(CMakePackageConfigHelpers)

if(BUILD_SHARED_LIBS OR NOT DEFINED BUILD_SHARED_LIBS)
  set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/aerostat")
  install(TARGETS aerostat_lib EXPORT aerostatTargets
          LIBRARY COMPONENT library NAMELINK_COMPONENT dev
          RUNTIME COMPONENT library)
  install(DIRECTORY include/aerostat DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev)
  install(EXPORT aerostatTargets NAMESPACE aerostat:: DESTINATION "${package_dir}" COMPONENT dev)
  configure_package_config_file(cmake/aerostatConfig.cmake.in
                                "${CMAKE_CURRENT_BINARY_DIR}/aerostatConfig.cmake"
                                INSTALL_DESTINATION "${package_dir}")
  write_basic_package_version_file("${CMAKE_CURRENT_BINARY_DIR}/aerostatConfigVersion.cmake"
                                   COMPATIBILITY SameMinorVersion)
  configure_file(cmake/aerostat.pc.in "${CMAKE_CURRENT_BINARY_DIR}/aerostat.pc" @ONLY)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/aerostatConfig.cmake"
                "${CMAKE_CURRENT_BINARY_DIR}/aerostatConfigVersion.cmake"
          DESTINATION "${package_dir}" COMPONENT dev)
  install(FILES "${CMAKE_CURRENT_BINARY_DIR}/aerostat.pc"
          DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig" COMPONENT dev)
  install(FILES examples/render_to_png.cpp examples/turn_around.cpp examples/CMakeLists.txt
          DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libaerostat-dev/examples" COMPONENT dev)
endif()
if(NOT AEROSTAT_PROGRAMS)
  return()
endif()

# Zsh reads completions of programs from this folder. The zsh of Debian reads them from
# share/zsh/vendor-completions.
set(AEROSTAT_ZSH_COMPLETIONS "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING
    "Folder from which zsh reads completions")

# host/scene/installed.cpp looks for the scenes in this folder, relative to that of the programs.
install(DIRECTORY scenes/ DESTINATION "${CMAKE_INSTALL_DATADIR}/aerostat/scenes"
        FILES_MATCHING PATTERN "*.json" REGEX "/(data|artwork|models)/")
install(DIRECTORY docs/manual DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# The manual links to these files.
install(FILES docs/performance.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES docs/gallery/viewer.png docs/gallery/swallows.jpg docs/gallery/whale.jpg DESTINATION "${CMAKE_INSTALL_DOCDIR}/gallery")

function(aerostat_install_extras program)
  install(FILES "packaging/man/${program}.1" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1")
  install(FILES "packaging/completions/${program}.bash" RENAME "${program}"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions")
  install(FILES "packaging/completions/${program}.fish"
          DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d")
  install(FILES "packaging/completions/_${program}" DESTINATION "${AEROSTAT_ZSH_COMPLETIONS}")
endfunction()

aerostat_install_extras(aerostat)
if(TARGET aerostat-viewer)
  aerostat_install_extras(aerostat-viewer)
  install(FILES packaging/aerostat-viewer.desktop
          DESTINATION "${CMAKE_INSTALL_DATADIR}/applications")
  install(FILES packaging/aerostat.svg
          DESTINATION "${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps")
endif()
