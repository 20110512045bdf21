// Reads late steps of a dataset from the source of its import.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace server::importer {

struct LateOptions {
    std::filesystem::path dataset;
    std::vector<std::size_t> steps; // numbers of steps; empty: all
    std::filesystem::path folder;   // for late arrays of datasets that cannot be written to; may be empty
    bool allow_bad = false;         // write a step although a part of it cannot be read
};

// Writes the late arrays of the steps, one step after the other. Prints "step N" after each step, and notes. Steps that
// have been written already are left out. Throws Error if the source is missing or has changed since the import, or if
// a step has another mesh or cannot be read completely. The other steps are written nevertheless.
void read_late_steps(const LateOptions& options);

} // namespace server::importer
