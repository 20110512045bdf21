// Runs a child process with limits, passes its output line by line, and reports how it ended.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace server::processes {

struct ChildLimits {
    std::uint64_t memory_bytes = 0; // limit of private writable memory, without mapped files; 0: no limit
    double seconds = 0;             // limit of the wall-clock time; 0: no limit
    // Limit of the wall-clock time without progress: no line of output, and no byte read or written. 0: no limit.
    double stalled_seconds = 0;
};

struct ChildEnd {
    int exit_code = -1; // exit code of the child; -1 if it did not exit by itself
    int signal = 0;     // the signal that ended the child; 0 if no signal did
    bool timed_out = false;
    bool stalled = false;
    bool cancelled = false;
    std::string errors; // the child's standard error, at most 64 KiB
};

// Runs arguments[0] (a path) to its end. `on_line` gets the lines of standard output on the calling thread. If `cancel`
// becomes true or a time limit is over, the child gets SIGTERM. If the child still runs 5 s later, it gets SIGKILL. The
// child is also killed if the calling thread ends. The child gets no signals from the terminal. Bytes read or written
// without a line of output are treated as progress for at most 8 * stalled_seconds. Therefore a child that reads the
// same file again and again is ended. Throws Error if the child cannot be started. Thread-safe.
[[nodiscard]] ChildEnd run_child(const std::vector<std::string>& arguments, const ChildLimits& limits,
                                 const std::function<void(std::string_view line)>& on_line,
                                 const std::atomic<bool>& cancel);

} // namespace server::processes
