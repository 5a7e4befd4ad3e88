# Warnings are errors. The numbers' flags: -fno-math-errno and -fno-trapping-math let loops with sqrt vectorise,
# -ffp-contract=off keeps results equal to the bit on every instruction set; never -ffast-math, for NaN means "unset".
add_library(loadpath_flags INTERFACE)
target_compile_options(loadpath_flags INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
                                                -fno-math-errno -fno-trapping-math -ffp-contract=off
                                                -fno-semantic-interposition)
target_compile_features(loadpath_flags INTERFACE cxx_std_20)
target_include_directories(loadpath_flags INTERFACE ${PROJECT_SOURCE_DIR})

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # g++ 12 reports these wrongly from inside the standard library when it inlines at -O2 and above.
  target_compile_options(loadpath_flags INTERFACE -Wno-restrict -Wno-maybe-uninitialized -Wno-stringop-overflow
                                                  -Wno-array-bounds -Wno-dangling-pointer)
  # It collects garbage from 800 MB on, not from 128: a tenth of the time of a build.
  target_compile_options(loadpath_flags INTERFACE --param=ggc-min-heapsize=800000)
endif()

if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  target_compile_options(loadpath_flags INTERFACE -Wno-sign-conversion  # as g++ reads -Wconversion
                                                  -Wreserved-identifier -Wreserved-macro-identifier)
endif()

if(LOADPATH_SANITIZE)
  # The address sanitizer also ends at a null pointer and beyond an object, and no pointer is cast to a wider type here: to
  # check that again costs more than a third of the time of a build.
  target_compile_options(loadpath_flags INTERFACE -fsanitize=address,undefined
                                                  -fno-sanitize=null,object-size,pointer-overflow,alignment,vptr
                                                  -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(loadpath_flags INTERFACE -fsanitize=address,undefined)
endif()

# A target whose branches the fuzz targets follow: what reads text. Of formulas and commands they would learn nothing.
function(loadpath_followed target)
  if(LOADPATH_FUZZ)
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# A release build of a target with little optimisation: of what runs once a command. Solver and sweeps keep -O3.
function(loadpath_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
endfunction()

# With sanitizers a target that takes little of the time of tests is not optimised: it is compiled in a third of the time.
function(loadpath_unoptimised target)
  if(LOADPATH_SANITIZE)
    target_compile_options(${target} PRIVATE -O0)
  endif()
endfunction()

# A program of sources that are not optimised: the libraries come first, because the linker keeps the first instance of a
# template.
function(loadpath_optimised_first target)
  target_link_options(${target} PRIVATE "SHELL:-Wl,--whole-archive $<TARGET_FILE:loadpath_calculators> \
    $<TARGET_FILE:loadpath_mechanism> $<TARGET_FILE:loadpath_lib> -Wl,--no-whole-archive")
endfunction()

# A command lives for milliseconds: a release of the program needs no relocation, and brings what it uses of the C++
# library along. Not wholly static: then the first exception sorts the unwind tables of the whole program, 6 ms.
function(loadpath_quick_start target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND NOT LOADPATH_SANITIZE)
    target_link_options(${target} PRIVATE $<$<CONFIG:Release>:-no-pie;-static-libstdc++;-static-libgcc>)
  endif()
endfunction()

# For sources with the loops of sweeps. The elimination of partial redundancies leaves truth values where paths meet, and
# g++ 12 puts no such loop into wide registers.
function(loadpath_sweeps target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-fno-tree-pre>)
  endif()
endfunction()
