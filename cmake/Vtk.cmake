# VTK is optional: FBRDF_VTK decides, and is on where it is found. Its modules are targets VTK::*; the optional ones are
# those of the example. A folder may ask for VTK once only, so they are named here together.
find_package(VTK 9.1 QUIET
  COMPONENTS CommonCore CommonDataModel CommonMath CommonTransforms RenderingCore RenderingOpenGL2 glew
  OPTIONAL_COMPONENTS FiltersCore InteractionStyle IOGeometry IOImage IOPLY RenderingUI)
option(FBRDF_VTK "Build fbrdf for VTK" ${VTK_FOUND})
if(FBRDF_VTK AND NOT VTK_FOUND)
  message(FATAL_ERROR "FBRDF_VTK=ON: found no VTK, expected 9.1 or newer (libvtk9-dev)")
endif()
if(FBRDF_VTK)
  message(STATUS "VTK ${VTK_VERSION}: building fbrdf_vtk")
else()
  message(STATUS "VTK: not built (FBRDF_VTK=OFF or libvtk9-dev not found)")
endif()
