# OpenSceneGraph is optional: FBRDF_OSG decides, and is on where it is found. fbrdf_osg carries its include folders and
# libraries.
find_package(OpenSceneGraph 3.6 QUIET COMPONENTS osgFX osgDB osgUtil osgViewer osgGA osgShadow)
option(FBRDF_OSG "Build the OpenSceneGraph node kit and its plugins" ${OPENSCENEGRAPH_FOUND})
if(FBRDF_OSG AND NOT OPENSCENEGRAPH_FOUND)
  message(FATAL_ERROR "FBRDF_OSG=ON: found no OpenSceneGraph, expected 3.6 or newer (libopenscenegraph-dev)")
endif()
if(FBRDF_OSG)
  message(STATUS "OpenSceneGraph ${OPENSCENEGRAPH_VERSION}: building the node kit osgFbrdf")
else()
  message(STATUS "OpenSceneGraph: not built (FBRDF_OSG=OFF or libopenscenegraph-dev not found)")
  return()
endif()

find_package(OpenGL REQUIRED)
add_library(fbrdf_osg INTERFACE)
target_include_directories(fbrdf_osg SYSTEM INTERFACE ${OPENSCENEGRAPH_INCLUDE_DIRS})
target_link_libraries(fbrdf_osg INTERFACE ${OPENSCENEGRAPH_LIBRARIES} OpenGL::GL)
