// A program started, watched and ended: its lines as they come, its limits, its end in words a caller can act on.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::processes {

struct ChildLimits {
    std::uint64_t memory_bytes = 0; // address space; 0: none
    double seconds = 0;             // wall clock; 0: none
    double stalled_seconds = 0;     // wall clock without a line of output or a byte read or written; 0: none
};

struct ChildEnd {
    int exit_code = -1; // when it exited by itself
    int signal = 0;     // when a signal ended it
    bool timed_out = false;
    bool stalled = false;
    bool cancelled = false;
    std::string errors; // its standard error, at most 64 KiB
};

// Runs arguments[0] (a path) to its end. `on_line` gets the lines of standard output on the calling thread. When
// `cancel` becomes true or a time is over it is asked to end (SIGTERM), and killed when it has not after 5 s. It is
// killed too when the calling thread dies, and gets no terminal signals of its own. Reading and writing without a line
// of output counts as getting on for eight times stalled_seconds: a file that is read over and over must end too.
// Throws Error when it cannot be started. Thread-safe.
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                                 const std::function<void(std::string_view line)>& on_line,
                                 const std::atomic<bool>& cancel);

} // namespace ciel::processes
