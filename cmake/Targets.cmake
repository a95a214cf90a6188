# Every target of the project is made by these functions, so language level, warnings and sanitizers are set in one place.

add_library(fbrdf_build_flags INTERFACE)
target_compile_features(fbrdf_build_flags INTERFACE cxx_std_17)
target_compile_options(fbrdf_build_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wold-style-cast -Wdouble-promotion -Wnon-virtual-dtor
  $<$<BOOL:${FBRDF_WARNINGS_AS_ERRORS}>:-Werror>)
target_compile_definitions(fbrdf_build_flags INTERFACE $<$<CONFIG:Debug>:FBRDF_ASSERTIONS>)
if(FBRDF_SANITIZE)
  target_compile_options(fbrdf_build_flags INTERFACE
    -fsanitize=${FBRDF_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(fbrdf_build_flags INTERFACE -fsanitize=${FBRDF_SANITIZE} -rdynamic)
  # GCC 12 takes std::regex for uninitialised where it is instrumented (GCC bug 105562).
  if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    target_compile_options(fbrdf_build_flags INTERFACE -Wno-maybe-uninitialized)
  endif()
  if(FBRDF_SANITIZE MATCHES address)
    # Every program gets these defaults, and no library.
    target_sources(fbrdf_build_flags INTERFACE
      $<$<STREQUAL:$<TARGET_PROPERTY:TYPE>,EXECUTABLE>:${PROJECT_SOURCE_DIR}/cmake/SanitizerDefaults.cpp>)
  endif()
endif()

# fbrdf_library(fbrdf_brdf ALIAS fbrdf::brdf SOURCES ... LINK ... PRIVATE_LINK ...) makes a static library. Its public
# headers are in include/ beside the caller, its private ones in src/.
function(fbrdf_library name)
  cmake_parse_arguments(ARG "" "ALIAS" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  add_library(${ARG_ALIAS} ALIAS ${name})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_include_directories(${name}
    PUBLIC $<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/include> $<INSTALL_INTERFACE:include>
    PRIVATE ${CMAKE_CURRENT_SOURCE_DIR}/src)
  target_compile_features(${name} PUBLIC cxx_std_17)
  target_link_libraries(${name} PUBLIC ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK} $<BUILD_INTERFACE:fbrdf_build_flags>)
endfunction()

# fbrdf_program(fbrdf SOURCES ... LINK ...) makes a program.
function(fbrdf_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE ${ARG_LINK} fbrdf_build_flags)
endfunction()
