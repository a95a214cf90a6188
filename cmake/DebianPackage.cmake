# cpack in the build folder makes one Debian package of all that is installed. What it depends on is read from its
# binaries; what only developers need (headers and CMake files are here, too) is suggested.
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
# The loader learns of the libraries as with Debian's own packages.
file(WRITE ${CMAKE_BINARY_DIR}/debian/triggers "activate-noawait ldconfig\n")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_BINARY_DIR}/debian/triggers)
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "libglm-dev, libopenimageio-dev, libpng-dev, nlohmann-json3-dev, pkg-config")
if(TARGET osgFbrdf)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${FBRDF_OSG_LIBRARY_DIR})
  set(CPACK_DEBIAN_PACKAGE_RECOMMENDS openscenegraph)
  string(APPEND CPACK_DEBIAN_PACKAGE_SUGGESTS ", libopenscenegraph-dev")
endif()
include(CPack)
