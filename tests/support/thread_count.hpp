// The number of the kernel's threads as long as this lives; all of the machine's afterwards.
#pragma once

#include "ciel/parallel.hpp"

namespace ciel::test {

class ThreadCount {
public:
    explicit ThreadCount(unsigned threads) { set_thread_count(threads); }
    ~ThreadCount() { set_thread_count(0); }
    ThreadCount(const ThreadCount&) = delete;
};

} // namespace ciel::test
