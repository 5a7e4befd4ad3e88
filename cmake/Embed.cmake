# loadpath_embed(target symbol BASE dir FILES...): builds the files into the target as
# `loadpath::embedded::symbol()`, see lib/text/embedded.hpp. The assembler reads them: as arrays in C++ they would take ten
# seconds a megabyte.
function(loadpath_embed target symbol)
  cmake_parse_arguments(EMBED "" "BASE" "FILES" ${ARGN})
  set(declared "")
  set(read "")
  set(rows "")
  set(index 0)
  foreach(file IN LISTS EMBED_FILES)
    file(RELATIVE_PATH name ${EMBED_BASE} ${file})
    set(begin "loadpath_${symbol}_${index}")
    string(APPEND declared "extern const char ${begin}[], ${begin}_end[];\n")
    string(APPEND read "    \"${begin}: .incbin \\\"${file}\\\"\\n${begin}_end: .byte 0\\n\"\n")
    string(APPEND rows "    {\"${name}\", std::string_view(${begin}, ${begin}_end)},\n")
    math(EXPR index "${index} + 1")
  endforeach()
  set(output ${CMAKE_CURRENT_BINARY_DIR}/embedded_${symbol}.cpp)
  configure_file(${PROJECT_SOURCE_DIR}/cmake/embedded.cpp.in ${output} @ONLY)
  set_source_files_properties(${output} PROPERTIES OBJECT_DEPENDS "${EMBED_FILES}" SKIP_PRECOMPILE_HEADERS ON
                                                   SKIP_UNITY_BUILD_INCLUSION ON)
  target_sources(${target} PRIVATE ${output})
endfunction()
