// Sets the kernel's number of threads during the object's lifetime. Afterwards, the number is again
// that of the machine.
#pragma once

#include "ciel/process_threads.hpp"

namespace ciel::test {

class ThreadCount {
public:
    explicit ThreadCount(unsigned threads) { set_thread_count(threads); }
    ~ThreadCount() { set_thread_count(0); }
    ThreadCount(const ThreadCount&) = delete;
};

} // namespace ciel::test
