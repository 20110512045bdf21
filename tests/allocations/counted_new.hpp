// Replaces operator new by a version that counts and can fail. The definitions are in a source file of their own,
// because g++ takes inlined ones for malloc.
#pragma once

#include <cstddef>

namespace ciel::test {

[[nodiscard]] std::size_t allocations(); // number of allocations so far, by all threads, without TBB's own

// Counts allocations of at least `bytes` bytes by all threads during its lifetime. Only one may exist.
class LargeAllocations {
public:
    explicit LargeAllocations(std::size_t bytes);
    ~LargeAllocations();
    LargeAllocations(const LargeAllocations&) = delete;
    [[nodiscard]] static std::size_t count();
};

// Counts the bytes that all threads hold more than at the beginning. Only one may exist.
class PeakBytes {
public:
    PeakBytes();
    ~PeakBytes();
    PeakBytes(const PeakBytes&) = delete;
    [[nodiscard]] static std::size_t peak();
};

// During its lifetime, the n-th allocation of any thread throws std::bad_alloc and all others succeed. Only one may
// exist.
class FailingAllocation {
public:
    explicit FailingAllocation(std::size_t nth);
    ~FailingAllocation();
    FailingAllocation(const FailingAllocation&) = delete;
    [[nodiscard]] static bool has_failed();
};

} // namespace ciel::test
