# The options of the build. All parts are on for the top-level project, and off where fbrdf is part of another project.
option(FBRDF_FITTER "Build the fitter and the fbrdf tool" ${PROJECT_IS_TOP_LEVEL})
option(FBRDF_VIEWER "Build fbrdf-viewer" ${PROJECT_IS_TOP_LEVEL})
option(FBRDF_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(FBRDF_WARNINGS_AS_ERRORS "Fail on compiler warnings" OFF)
set(FBRDF_SANITIZE "" CACHE STRING "Sanitizers: 'address,undefined', 'thread', or nothing")

if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()
if(FBRDF_SANITIZE MATCHES "thread" AND FBRDF_SANITIZE MATCHES "address|leak")
  message(FATAL_ERROR "FBRDF_SANITIZE='${FBRDF_SANITIZE}': thread cannot be combined with address or leak")
endif()
if(PROJECT_IS_TOP_LEVEL)
  set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
  find_program(FBRDF_CCACHE ccache)
  if(FBRDF_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    # Paths count from the project's root, so that another clone of the same sources finds the compiled objects. ccache
    # caches units with precompiled headers only where it may ignore the times and macros of those headers.
    set(launcher ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=true
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${FBRDF_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${launcher})
    set(CMAKE_CXX_COMPILER_LAUNCHER ${launcher})
  endif()
endif()
