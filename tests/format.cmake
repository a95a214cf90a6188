# cmake -DCLANG_FORMAT=... -DROOT=... [-DFILES=...] -P format.cmake: fails unless clang-format would leave every C++ file
# below ROOT's source folders (or those of FILES) as it is.
if(NOT FILES)
  foreach(folder runtime fitter sample_app plugin tests)
    file(GLOB_RECURSE found ${ROOT}/${folder}/*.h ${ROOT}/${folder}/*.cpp)
    list(APPEND FILES ${found})
  endforeach()
endif()
if(NOT FILES)
  message(FATAL_ERROR "${ROOT}: found no C++ file to check")
endif()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${FILES}
  WORKING_DIRECTORY ${ROOT} ERROR_VARIABLE complaints RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${complaints}\nclang-format -i FILE puts a file right.")
endif()
