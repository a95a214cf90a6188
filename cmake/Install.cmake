# What `cmake --install` leaves: programs, libraries, headers, plugins, and a package for find_package(fbrdf COMPONENTS io osg vtk).
# Without components it gives brdf, environment, plan, shaders, runtime and c; io needs OpenEXR and libpng, osg
# OpenSceneGraph, vtk VTK 9.1.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
include(cmake/ManPages.cmake)
set(FBRDF_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/fbrdf)

# fbrdf_export(SET TARGET...): fbrdf_x becomes fbrdf::x in fbrdfSETTargets.cmake.
function(fbrdf_export set)
  foreach(target ${ARGN})
    string(REGEX REPLACE "^fbrdf_" "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endforeach()
  install(TARGETS ${ARGN} EXPORT fbrdf${set}Targets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
    INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
  install(EXPORT fbrdf${set}Targets NAMESPACE fbrdf:: DESTINATION ${FBRDF_PACKAGE_DIR})
endfunction()

fbrdf_export(Core fbrdf_base fbrdf_brdf fbrdf_environment fbrdf_plan fbrdf_shaders fbrdf_runtime fbrdf_c)
fbrdf_export(Io fbrdf_pictures fbrdf_io)
if(TARGET osgFbrdf)
  fbrdf_export(Osg osgFbrdf fbrdf_osg)
endif()
if(TARGET fbrdf_vtk)
  fbrdf_export(Vtk fbrdf_vtk)
endif()
foreach(part base brdf environment io plan shaders gl)
  install(DIRECTORY runtime/${part}/include/fbrdf DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endforeach()

foreach(program fbrdf fbrdf-viewer)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()

if(TARGET man)
  install(DIRECTORY ${FBRDF_MAN_DIR}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
endif()
install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} RENAME copyright)
install(FILES README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} FILES_MATCHING PATTERN "*.md" PATTERN images EXCLUDE)

configure_package_config_file(cmake/fbrdfConfig.cmake.in ${CMAKE_BINARY_DIR}/fbrdfConfig.cmake
  INSTALL_DESTINATION ${FBRDF_PACKAGE_DIR})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/fbrdfConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/fbrdfConfig.cmake ${CMAKE_BINARY_DIR}/fbrdfConfigVersion.cmake
  DESTINATION ${FBRDF_PACKAGE_DIR})
