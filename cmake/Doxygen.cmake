# The target `docs`: HTML of the public headers and of the pages, in docs/html of the build folder. It exists where
# Doxygen is installed, is no part of `all`, and ends with an error where Doxygen has a warning.
find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  message(STATUS "Doxygen: not found, no target docs")
  return()
endif()

set(FBRDF_DOXYGEN_OUTPUT ${PROJECT_BINARY_DIR}/docs)
file(GLOB includes LIST_DIRECTORIES TRUE runtime/*/include fitter/*/include sample_app/*/include plugin/osg/*/include plugin/vtk/include)
file(GLOB pages README.md CONTRIBUTING.md CHANGELOG.md docs/*.md)
file(GLOB_RECURSE readmes runtime/README.md fitter/README.md plugin/README.md sample_app/README.md tests/README.md
  cmake/README.md)
list(JOIN includes "\" \"" FBRDF_DOXYGEN_INCLUDES)
list(APPEND pages ${readmes})
list(JOIN pages "\" \"" quoted)
set(FBRDF_DOXYGEN_INCLUDES "\"${FBRDF_DOXYGEN_INCLUDES}\"")
set(FBRDF_DOXYGEN_INPUT "\"${quoted}\" ${FBRDF_DOXYGEN_INCLUDES}")
configure_file(docs/Doxyfile.in ${PROJECT_BINARY_DIR}/Doxyfile @ONLY)
file(MAKE_DIRECTORY ${FBRDF_DOXYGEN_OUTPUT})
add_custom_target(docs
  COMMAND ${DOXYGEN_EXECUTABLE} ${PROJECT_BINARY_DIR}/Doxyfile
  COMMENT "Writing ${FBRDF_DOXYGEN_OUTPUT}/html/index.html" VERBATIM)
