// A function with this attribute is compiled twice: for AVX2, and for any x86-64 processor. The loader chooses one of
// them when the program starts. tests/unit/ciel/uses_vector_units checks the compiled code. Not in the paper.
#pragma once

// Builds with sanitizers do not use the attribute, because the loader would choose before the sanitizer is initialized.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_THREAD__) &&                \
    !defined(__SANITIZE_ADDRESS__)
#define CIEL_FOR_ALL_VECTOR_UNITS __attribute__((target_clones("avx2", "default")))
#else
#define CIEL_FOR_ALL_VECTOR_UNITS
#endif
