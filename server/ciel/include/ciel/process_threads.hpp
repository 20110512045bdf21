// The number of threads of the whole process: for programs that own it, such as the server's command line. Not
// installed: a library that uses the kernel limits its own calls instead (Options::threads, with_threads). Not in the
// paper.
#pragma once

#include "ciel/parallel.hpp"

namespace ciel {

void set_thread_count(unsigned threads); // 0: all hardware threads; must not be called while a loop runs

} // namespace ciel
