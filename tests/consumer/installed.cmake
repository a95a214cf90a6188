# Installs into a folder of its own, copies the examples out of the tree, builds them with find_package(fbrdf) against that
# folder alone, and starts each: without arguments they print how they are used. The installed viewer writes
# a JPEG. Comments of headers name files that are installed, and no others.
cmake_minimum_required(VERSION 3.25)
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

# The viewer finds the module for JPEG from its own place.
if(EXISTS ${WORK}/prefix/bin/fbrdf-viewer)
  run(0 ${CMAKE_COMMAND} -E env --unset=FBRDF_PICTURES_MODULE ${WORK}/prefix/bin/fbrdf-viewer --headless --size 8x8
    --technique reference --material lambert:albedo=0.5 --out ${WORK}/picture.jpg)
endif()

file(GLOB_RECURSE installed RELATIVE ${WORK}/prefix ${WORK}/prefix/include/fbrdf/* ${WORK}/prefix/share/*)
file(GLOB_RECURSE headers ${WORK}/prefix/include/fbrdf/*.h ${WORK}/prefix/include/fbrdf/*.hpp)
foreach(header ${headers})
  file(STRINGS ${header} lines REGEX "(//|\\*).*[a-z]\\.(h|hpp|md|glsl)")
  string(REGEX MATCHALL "[A-Za-z0-9_/-]+\\.(hpp|h|md|glsl)" names "${lines}")
  foreach(name ${names})
    string(REGEX MATCH "/${name}(;|$)" found "/${installed}")
    if(NOT found)
      message(FATAL_ERROR "${header}: found ${name} in a comment, expected the name of an installed file")
    endif()
  endforeach()
endforeach()
