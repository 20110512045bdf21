// Marks a vectorizable loop to be compiled for AVX2 and for the baseline; the program picks one when it starts.
// tests/unit/ciel/uses_vector_units checks the compiled code. Not in the paper.
#pragma once

// Not with sanitizers, which are not initialized yet when the loader chooses between the copies.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__) &&                \
    !defined(__SANITIZE_ADDRESS__)
#define CIEL_FOR_ALL_VECTOR_UNITS __attribute__((target_clones("avx2", "default")))
#else
#define CIEL_FOR_ALL_VECTOR_UNITS
#endif
