// Loops that the compiler turns into vector operations, for the units that this machine has: chosen when the program
// starts. tests/unit/ciel looks into the code that it has made. Not in the paper.
#pragma once

// The sanitizers are not ready yet when the choice is made.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__) &&                \
    !defined(__SANITIZE_ADDRESS__)
#define CIEL_FOR_ALL_VECTOR_UNITS __attribute__((target_clones("avx2", "default")))
#else
#define CIEL_FOR_ALL_VECTOR_UNITS
#endif
