// Attributes of loops and functions for the vector registers of the CPU (SIMD). Wide and narrow registers give the same
// bits, because nothing is contracted.
#pragma once

#if defined(__GNUC__) && !defined(__clang__)
/// Before a loop whose turns do not depend on each other.
#define LOADPATH_POINTWISE _Pragma("GCC ivdep")
/// Likewise before a loop over the few lanes of a vector: unrolled first it would not be vectorised.
#define LOADPATH_LANEWISE _Pragma("GCC ivdep") _Pragma("GCC unroll 1")
#else
#define LOADPATH_POINTWISE
#define LOADPATH_LANEWISE
#endif

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__)
/// A loop over points or lanes: fully inlined, and compiled for wide registers too; the CPU decides at startup.
#define LOADPATH_LANES __attribute__((flatten, target_clones("default", "arch=x86-64-v3")))
/// A loop over a column: likewise, and for the widest registers.
#define LOADPATH_COLUMNS __attribute__((flatten, target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define LOADPATH_LANES
#define LOADPATH_COLUMNS
#endif

#if defined(__x86_64__)
/// A function with AVX2 instructions; the caller checks that the CPU has them.
#define LOADPATH_AVX2 __attribute__((target("avx2")))
#endif

/// A function that uses the instructions of its caller, with AVX2 or without.
#define LOADPATH_INLINE inline __attribute__((always_inline))
