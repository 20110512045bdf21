// The kernel's one seam to threads: TBB, std::thread or serial, chosen when built (CIEL_PARALLEL).
#pragma once

#include <cstddef>
#include <functional>

namespace ciel {

// Calls body(begin, end) for disjoint ranges that cover [0, count), each of about `grain` items, on any thread. An
// exception thrown by a body reaches the caller after all ranges have ended.
void parallel_for(std::size_t count, std::size_t grain,
                  const std::function<void(std::size_t begin, std::size_t end)>& body);

void set_thread_count(unsigned threads); // 0: all of the machine's; not while a loop runs
[[nodiscard]] unsigned thread_count();

} // namespace ciel
