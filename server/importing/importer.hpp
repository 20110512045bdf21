// Runs imports in the separate process ciel-import. If a file crashes this process, the caller gets an error sentence,
// and no partial dataset remains.
#pragma once

#include "importing/import_options.hpp"
#include "limits/limits.hpp"

#include <atomic>
#include <filesystem>
#include <functional>

namespace server::importing {

// By default, the numbers are those of limits::Limits, and the options are those of `ciel import`. With a limit of the
// memory, a damaged file cannot exhaust it.
struct ImportLimits { // a number of 0 is no limit
    ImportLimits();

    double memory_gigabytes;
    double seconds = 0;
    double stalled_seconds;                       // longest time without progress
    std::string memory_option = "--memory-limit"; // the options that errors name
    std::string stalled_option = "--stall-limit";
};

// Returns the limits of imports that a server starts.
[[nodiscard]] ImportLimits import_limits_of_server(const limits::Limits& limits);

struct ImportListener {
    std::function<void(double share, const std::string& phase)> progress; // share in [0, 1]
    std::function<void(const std::string& line)> line;                    // notes and listings
};

struct ImportEnd {
    int exit_code = 0;   // 0 done, 1 failed, 2 wrong usage, 3 done with data left out
    std::string problem; // a sentence; empty for exit code 0
    // True if the dataset is complete although ciel-import was ended, for example while it removed an old dataset.
    bool is_written = false;
};

// `values`: options by ImportOption::name. After a failure, removes unfinished files at values["output"]. Throws Error
// if ciel-import cannot be found or started. Thread-safe.
[[nodiscard]] ImportEnd run_import(const ImportValues& values, const ImportLimits& limits,
                                   const ImportListener& listener, const std::atomic<bool>& cancel);

// Returns the path of ciel-import, in the directory of this program or on PATH. Throws Error if ciel-import is not
// found.
[[nodiscard]] std::filesystem::path find_import_program();

} // namespace server::importing
