# fbrdf_embed_shaders(TARGET [FUNCTION NAME] FILE...) makes the texts of GLSL files part of TARGET, as the function that
# EmbeddedShaders.h declares, or as the function NAME, which takes and returns the same. The build runs this file as a
# script (-P), which writes the source, and runs it again when a GLSL file changes.
if(CMAKE_SCRIPT_MODE_FILE)
  set(source "// Written by EmbedShaders.cmake.\n#include <string_view>\n\nnamespace fbrdf {\n\n")
  string(APPEND source "std::string_view ${FUNCTION}(std::string_view name);\n\n")
  string(APPEND source "std::string_view ${FUNCTION}(std::string_view name)\n{\n")
  string(REPLACE "|" ";" files "${FILES}")
  foreach(file ${files})
    file(READ ${file} text)
    get_filename_component(name ${file} NAME)
    string(APPEND source "    if (name == \"${name}\") return R\"fbrdf(${text})fbrdf\";\n")
  endforeach()
  string(APPEND source "    return {};\n}\n\n}  // namespace fbrdf\n")
  file(WRITE ${OUTPUT} "${source}")
  return()
endif()

set(FBRDF_EMBED_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(fbrdf_embed_shaders target)
  cmake_parse_arguments(ARG "" "FUNCTION" "" ${ARGN})
  if(NOT ARG_FUNCTION)
    set(ARG_FUNCTION embeddedShader)
  endif()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/EmbeddedShaders.cpp)
  list(TRANSFORM ARG_UNPARSED_ARGUMENTS PREPEND ${CMAKE_CURRENT_SOURCE_DIR}/ OUTPUT_VARIABLE files)
  list(JOIN files "|" joined)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} "-DFILES=${joined}" -DFUNCTION=${ARG_FUNCTION} -DOUTPUT=${output} -P ${FBRDF_EMBED_SCRIPT}
    DEPENDS ${files} ${FBRDF_EMBED_SCRIPT}
    COMMENT "Embedding the shaders" VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
