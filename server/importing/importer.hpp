// Runs imports in the separate process ciel-import. If a file crashes it, the caller gets a sentence, and no partial
// dataset remains.
#pragma once

#include "importing/import_options.hpp"

#include <atomic>
#include <filesystem>
#include <functional>

namespace ciel::importing {

// Returns four fifths of machine_memory(), in GB, so that a damaged file cannot exhaust the memory.
[[nodiscard]] double default_memory_gigabytes();

struct ImportLimits { // 0: no limit
    double memory_gigabytes = default_memory_gigabytes();
    double seconds = 0;
    // Time without progress (child_process.hpp). A valid import is silent for longest while it builds a huge mesh.
    double stalled_seconds = 1800;
};

struct ImportListener {
    std::function<void(double share, const std::string& phase)> progress; // share in [0, 1]
    std::function<void(const std::string& line)> line;                    // notes and listings
};

struct ImportEnd {
    int exit_code = 0;   // 0 done, 1 failed, 2 wrong usage, 3 done with data left out
    std::string problem; // a sentence; empty for exit code 0
};

// `values`: options by their names in import_options. Removes leftovers at values["output"] after a failure. Throws
// Error if the program cannot be found or started. Thread-safe.
[[nodiscard]] ImportEnd run_import(const ImportValues& values, const ImportLimits& limits,
                                   const ImportListener& listener, const std::atomic<bool>& cancel);

// Returns the path of ciel-import, beside this program or on PATH. Throws Error when there is none.
[[nodiscard]] std::filesystem::path find_import_program();

} // namespace ciel::importing
