# Installs into a folder of its own, and draws with the plugin that is there.
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
execute_process(
  COMMAND ${CMAKE_COMMAND} -E env FBRDF_OGRE_PLUGIN=${WORK}/${LIBDIR}/OGRE/Plugin_Fbrdf
    ${TEST} --gtest_filter=PluginsCfg.*:*AnyNumberOfLightsEqualsTheRuntime/GL3Plus
  WORKING_DIRECTORY ${SOURCE} COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE_RECURSE ${WORK})
