// Compilation of loops over columns.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__OPTIMIZE__) && \
    !defined(__SANITIZE_ADDRESS__)
/// A loop over a column: fully inlined, and compiled for wide registers too; the CPU decides at startup. The bits are
/// the same, because nothing is contracted.
#define LOADPATH_COLUMNS __attribute__((flatten, target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4")))
#else
#define LOADPATH_COLUMNS
#endif
