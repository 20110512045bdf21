// Reads late steps of a dataset from the source of its import.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace server::importer {

struct LateOptions {
    std::filesystem::path dataset;
    std::vector<std::size_t> steps; // numbers of steps; empty: all
    std::filesystem::path folder;   // of late arrays whose dataset cannot be written to; may be empty
};

// Writes the late arrays of the steps, one step after the other. Prints "step N" after each step. Steps that have been
// written already are left out. Throws Error if the source is missing, has changed since the import, or has another
// mesh at a step; the steps before stay written.
void read_late_steps(const LateOptions& options);

} // namespace server::importer
