# CPack runs this script on the folders from which it makes the packages. The script adds the files
# that Debian requires beyond those of `cmake --install`.
file(READ "${CPACK_AEROSTAT_SOURCE_DIR}/LICENSE" licence)
string(TIMESTAMP date "%a, %d %b %Y %H:%M:%S +0000" UTC)

function(stage_package component package)
  set(root "${CPACK_TEMPORARY_INSTALL_DIRECTORY}/${component}${CPACK_PACKAGING_INSTALL_PREFIX}")
  if(NOT EXISTS "${root}")
    return()
  endif()
  set(docs "${root}/${CPACK_AEROSTAT_DOC_ROOT}/${package}")
  file(WRITE "${docs}/copyright" "${licence}")
  configure_file("${CPACK_AEROSTAT_SOURCE_DIR}/CHANGELOG.md" "${docs}/changelog" COPYONLY)
  file(WRITE "${docs}/changelog.Debian"
       "aerostat (${CPACK_PACKAGE_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}) unstable; urgency=low\n\n"
       "  * See changelog.gz for the changes.\n\n"
       " -- ${CPACK_PACKAGE_CONTACT}  ${date}\n")
  file(GLOB pages "${root}/${CPACK_AEROSTAT_MAN_DIR}/man1/*.1")
  foreach(file ${pages} "${docs}/changelog" "${docs}/changelog.Debian")
    execute_process(COMMAND gzip -9nf "${file}" COMMAND_ERROR_IS_FATAL ANY)
  endforeach()
  file(CHMOD "${docs}/copyright" "${docs}/changelog.gz" "${docs}/changelog.Debian.gz"
       PERMISSIONS OWNER_READ OWNER_WRITE GROUP_READ WORLD_READ)
endfunction()

stage_package(programs aerostat)
stage_package(library "${CPACK_AEROSTAT_LIBRARY_PACKAGE}")
stage_package(dev libaerostat-dev)
