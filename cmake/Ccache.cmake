# Where ccache is installed, what was compiled before is taken from it, but for precompiled headers. They hold the path of the
# sources, so a clone in another folder has everything that reads them compiled once more. What ccache cannot see of a
# precompiled header does not matter here: nothing uses __DATE__ or __TIME__, and no macro changes its meaning.
find_program(LOADPATH_CCACHE ccache)
mark_as_advanced(LOADPATH_CCACHE)
if(LOADPATH_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
      CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      sh ${PROJECT_SOURCE_DIR}/cmake/ccache.sh ${LOADPATH_CCACHE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_compile_options(-fpch-preprocess)  # else it does not see which precompiled header a source reads
  else()
    add_compile_options("SHELL:-Xclang -fno-pch-timestamp")
  endif()
endif()
