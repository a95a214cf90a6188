# cmake -DCLANG_FORMAT=... -DROOT=... -P format.cmake: fails unless clang-format would leave every C and C++ file below
# ROOT's source folders as it is. It globs, so that no file is forgotten in a list.
foreach(folder runtime fitter sample_app plugin tests)
  foreach(ending c cpp h hpp inc inl)
    file(GLOB_RECURSE found ${ROOT}/${folder}/*.${ending})
    list(APPEND FILES ${found})
  endforeach()
endforeach()
if(NOT FILES)
  message(FATAL_ERROR "${ROOT}: found no C++ file to check")
endif()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${FILES}
  WORKING_DIRECTORY ${ROOT} ERROR_VARIABLE complaints RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "${complaints}\nclang-format -i FILE puts a file right.")
endif()
