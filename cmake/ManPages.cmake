# The target `man`: manual pages of the programs that are installed and of their subcommands, written from their own --help.
# It is part of `all` where help2man is installed and the programs can run on the machine that builds them.
set(FBRDF_MAN_PROGRAMS)
foreach(program fbrdf fbrdf-viewer)
  if(TARGET ${program})
    list(APPEND FBRDF_MAN_PROGRAMS ${program})
  endif()
endforeach()
find_program(HELP2MAN help2man)
mark_as_advanced(HELP2MAN)
if(NOT HELP2MAN OR CMAKE_CROSSCOMPILING OR NOT FBRDF_MAN_PROGRAMS)
  message(STATUS "Manual pages: not written (help2man: ${HELP2MAN})")
  return()
endif()

set(FBRDF_MAN_DIR ${PROJECT_BINARY_DIR}/man)
set(FBRDF_MAN_MAKER ${PROJECT_SOURCE_DIR}/docs/make_man.py)
set(FBRDF_MAN_STAMPS)
foreach(program ${FBRDF_MAN_PROGRAMS})
  set(stamp ${PROJECT_BINARY_DIR}/man-${program}.stamp)
  add_custom_command(OUTPUT ${stamp}
    COMMAND ${Python3_EXECUTABLE} ${FBRDF_MAN_MAKER} $<TARGET_FILE:${program}> ${PROJECT_VERSION} ${FBRDF_MAN_DIR}
    COMMAND ${CMAKE_COMMAND} -E touch ${stamp}
    DEPENDS ${program} ${FBRDF_MAN_MAKER} COMMENT "Writing the manual pages of ${program}" VERBATIM)
  list(APPEND FBRDF_MAN_STAMPS ${stamp})
endforeach()
add_custom_target(man ALL DEPENDS ${FBRDF_MAN_STAMPS})
