// Runs a child process with limits, passes its output line by line, and reports how it ended.
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
    int exit_code = -1; // if the child exited by itself
    int signal = 0;     // if a signal ended the child
    bool timed_out = false;
    bool stalled = false;
    bool cancelled = false;
    std::string errors; // the child's standard error, at most 64 KiB
};

// Runs arguments[0] (a path) to its end. `on_line` gets the lines of standard output on the calling thread.
// When `cancel` becomes true or a time limit is over, the child gets SIGTERM, and SIGKILL 5 s later if it still runs.
// The child is also killed when the calling thread dies. It gets no signals from the terminal.
// Bytes read or written without a line of output count as progress for at most 8 * stalled_seconds, so that a child
// that reads a file over and over is ended. Throws Error if the child cannot be started. Thread-safe.
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                                 const std::function<void(std::string_view line)>& on_line,
                                 const std::atomic<bool>& cancel);

} // namespace ciel::processes
