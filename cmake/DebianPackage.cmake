# `cpack` in the build folder makes one Debian package of everything that is installed. The packages that it depends on
# are read from its binaries. It has headers and CMake files too, and suggests the packages that only developers need.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME fbrdf)
set(CPACK_PACKAGE_CONTACT "The fbrdf authors <fbrdf@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_COMPRESSION_TYPE gzip)  # a third of the time of xz
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# The trigger makes the loader aware of the libraries, as those of Debian's own packages do.
file(WRITE ${CMAKE_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libglm-dev, libopenexr-dev, libpng-dev")
# Libraries of our own that others of ours need.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_BINARY_DIR}/lib)
if(TARGET osgFbrdf)
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS openscenegraph)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", libopenscenegraph-dev")
endif()
if(TARGET fbrdf_vtk)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", libvtk9-dev")
endif()
include(CPack)
