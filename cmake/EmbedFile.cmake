# fbrdf_embed_file(TARGET FUNCTION FILE) makes the bytes of a file part of TARGET, as
#   std::string_view fbrdf::FUNCTION();
# The build runs this file as a script (-P), which writes the source, and runs it again when the file changes.
if(CMAKE_SCRIPT_MODE_FILE)
  file(READ ${FILE} hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(REGEX REPLACE "((0x..,)(0x..,)(0x..,)(0x..,)(0x..,)(0x..,)(0x..,)(0x..,))" "\\1\n" bytes "${bytes}")
  file(WRITE ${OUTPUT} "// Written by EmbedFile.cmake.\n#include <string_view>\n\nnamespace fbrdf {\n
std::string_view ${FUNCTION}();\n
std::string_view ${FUNCTION}()\n{\n    static const unsigned char bytes[] = {\n${bytes}0};
    return {reinterpret_cast<const char*>(bytes), sizeof bytes - 1};\n}\n\n}  // namespace fbrdf\n")
  return()
endif()

set(FBRDF_EMBED_FILE_SCRIPT ${CMAKE_CURRENT_LIST_FILE})
function(fbrdf_embed_file target function file)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  set(input ${CMAKE_CURRENT_SOURCE_DIR}/${file})
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DFILE=${input} -DFUNCTION=${function} -DOUTPUT=${output} -P ${FBRDF_EMBED_FILE_SCRIPT}
    DEPENDS ${input} ${FBRDF_EMBED_FILE_SCRIPT}
    COMMENT "Embedding ${file}" VERBATIM)
  target_sources(${target} PRIVATE ${output})
  set_source_files_properties(${output} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
endfunction()
