// Sets the number of threads of the whole process, for programs such as the server. This header is not installed: a
// library that uses the kernel must limit only its own calls (Options::threads, with_threads). Not in the paper.
#pragma once

#include "ciel/parallel.hpp"

namespace ciel {

void set_thread_count(unsigned threads); // 0: all hardware threads; do not call it while a loop runs

} // namespace ciel
