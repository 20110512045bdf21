// The program's operator new, which counts and fails when told to. In a file of its own: inlined into its callers, g++
// takes it for malloc.
#pragma once

#include <cstddef>

namespace ciel::test {

[[nodiscard]] std::size_t allocations(); // so far, by any thread

// While it lives, allocations of at least so many bytes are counted, of any thread. One at a time.
class LargeAllocations {
public:
    explicit LargeAllocations(std::size_t bytes);
    ~LargeAllocations();
    LargeAllocations(const LargeAllocations&) = delete;
    [[nodiscard]] static std::size_t count();
};

// While it lives, the n-th allocation from here on throws bad_alloc, whoever asks for it; the others do not. One at a
// time.
class FailingAllocation {
public:
    explicit FailingAllocation(std::size_t nth);
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;
    [[nodiscard]] static bool has_failed();
};

} // namespace ciel::test
