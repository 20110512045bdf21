// Exports of the WebAssembly module: memory for the cases, the extraction, and the address of the results.
#include "wasm/extract_everywhere.hpp"

namespace {
ciel::test::Bytes cases, results;
}

[[clang::export_name("room_for_cases")]] std::byte* room_for_cases(std::size_t size) {
    cases.resize(size);
    return cases.data();
}

// Returns the size of the results in bytes.
[[clang::export_name("extract")]] std::size_t extract() {
    results = ciel::test::extract_everywhere(cases);
    return results.size();
}

[[clang::export_name("results")]] const std::byte* results_begin() { return results.data(); }
