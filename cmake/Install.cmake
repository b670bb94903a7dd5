# What `cmake --install` puts beside the programs. Included after the programs' folders.
include(GNUInstallDirs)

# Debian's zsh looks in share/zsh/vendor-completions.
set(AEROSTAT_ZSH_COMPLETIONS "${CMAKE_INSTALL_DATADIR}/zsh/site-functions" CACHE STRING
    "Where zsh finds completions")

# Beside the folder of the programs, where host/scene/installed.cpp looks for them.
install(DIRECTORY scenes/ DESTINATION "${CMAKE_INSTALL_DATADIR}/aerostat/scenes"
        FILES_MATCHING PATTERN "*.json")
install(DIRECTORY docs/manual DESTINATION "${CMAKE_INSTALL_DOCDIR}")
# What the manual links to.
install(FILES docs/performance.md DESTINATION "${CMAKE_INSTALL_DOCDIR}")
install(FILES docs/gallery/viewer.png DESTINATION "${CMAKE_INSTALL_DOCDIR}/gallery")

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
