# Installs into a folder of its own, copies the examples out of the tree, builds them with find_package(fbrdf) against that
# folder alone, and starts each: without arguments they print how they are used.
function(run expected)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL expected)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${output}")
  endif()
endfunction()
file(REMOVE_RECURSE ${WORK})
file(MAKE_DIRECTORY ${WORK}/build)
file(COPY ${EXAMPLES}/ DESTINATION ${WORK}/examples)
run(0 ${CMAKE_COMMAND} --install ${BUILD} --prefix ${WORK}/prefix)
run(0 ${CMAKE_COMMAND} -S ${WORK}/examples -B ${WORK}/build -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${WORK}/prefix
  -DCMAKE_BUILD_TYPE=Debug)
run(0 ${CMAKE_COMMAND} --build ${WORK}/build)
foreach(example glfw_host glfw_host_c own_shaders)
  run(2 ${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH ${WORK}/build/${example})
endforeach()
