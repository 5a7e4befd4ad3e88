# loadpath_batches(target SOURCES...): compiles together the first source of each folder here, the second of each, and so
# on. What a source keeps to itself stands in the namespace of its folder, so that sources of different folders agree.
function(loadpath_batches target)
  foreach(source IN LISTS ARGN)
    file(RELATIVE_PATH name ${CMAKE_CURRENT_SOURCE_DIR} ${source})
    string(REGEX REPLACE "/.*" "" folder ${name})
    math(EXPR sources_of_${folder} "${sources_of_${folder}} + 1")
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP "batch_${sources_of_${folder}}")
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
