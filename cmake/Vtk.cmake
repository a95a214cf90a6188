# VTK is optional: FBRDF_VTK decides, and is on where it is found. fbrdf_vtk_engine carries its modules.
set(FBRDF_VTK_MODULES CommonCore CommonDataModel CommonExecutionModel CommonMath CommonTransforms RenderingCore
  RenderingOpenGL2 glew)
find_package(VTK 9.1 QUIET COMPONENTS ${FBRDF_VTK_MODULES})
option(FBRDF_VTK "Build fbrdf for VTK" ${VTK_FOUND})
if(FBRDF_VTK AND NOT VTK_FOUND)
  message(FATAL_ERROR "FBRDF_VTK=ON: found no VTK, expected 9.1 or newer (libvtk9-dev)")
endif()
if(FBRDF_VTK)
  message(STATUS "VTK ${VTK_VERSION}: building fbrdf_vtk")
else()
  message(STATUS "VTK: not built (FBRDF_VTK=OFF or libvtk9-dev not found)")
endif()
