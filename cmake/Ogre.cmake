# OGRE is optional: FBRDF_OGRE decides, and is on where it is found. fbrdf_ogre carries its include folders and libraries.
find_package(OGRE 1.12 QUIET CONFIG COMPONENTS RTShaderSystem HINTS /usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/OGRE/cmake)
if(OGRE_FOUND AND OGRE_RTShaderSystem_FOUND)
  set(found ON)
else()
  set(found OFF)
endif()
option(FBRDF_OGRE "Build the plugin for OGRE" ${found})
if(FBRDF_OGRE AND NOT found)
  message(FATAL_ERROR "FBRDF_OGRE=ON: found no OGRE with RTShaderSystem, expected 1.12 or newer (libogre-1.12-dev)")
endif()
if(FBRDF_OGRE)
  message(STATUS "OGRE ${OGRE_VERSION}: building Plugin_Fbrdf")
else()
  message(STATUS "OGRE: not built (FBRDF_OGRE=OFF or libogre-1.12-dev not found)")
  return()
endif()

add_library(fbrdf_ogre INTERFACE)
target_include_directories(fbrdf_ogre SYSTEM INTERFACE ${OGRE_INCLUDE_DIRS})
target_link_libraries(fbrdf_ogre INTERFACE OgreMain OgreRTShaderSystem)
# Newer releases of OGRE 14 hand the factories of lighting stages a ScriptProperty instead of the nodes of a script.
include(CheckCXXSourceCompiles)
set(CMAKE_REQUIRED_LIBRARIES fbrdf_ogre)
check_cxx_source_compiles("
  #include <OgreShaderSubRenderState.h>
  using namespace Ogre;
  using namespace Ogre::RTShader;
  struct Factory : SubRenderStateFactory {
    SubRenderState* createInstance(const ScriptProperty&, Pass*, SGScriptTranslator*) override;
  };
  int main() { return 0; }" FBRDF_OGRE_SCRIPT_PROPERTY)
unset(CMAKE_REQUIRED_LIBRARIES)
if(FBRDF_OGRE_SCRIPT_PROPERTY)
  target_compile_definitions(fbrdf_ogre INTERFACE FBRDF_OGRE_SCRIPT_PROPERTY)
endif()
# For tests and the example, which start OGRE without its plugins.cfg and resources.cfg.
set_property(GLOBAL PROPERTY FBRDF_OGRE_MEDIA_DIR ${OGRE_MEDIA_DIR})
set_property(GLOBAL PROPERTY FBRDF_OGRE_PLUGIN_DIR ${OGRE_PLUGIN_DIR})
