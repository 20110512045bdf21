// Appends steps to a dataset, with the same checks and errors for `ciel append` and for uploads to a server.
#pragma once

#include "store/dataset.hpp"

#include <functional>

namespace server::store {

// An array that a caller wants to append: "p" for values on points, "cell:p" for values on cells.
struct WantedArray {
    std::string name;
    std::optional<std::size_t> components; // nullopt: as many as the array has in the dataset; 1 for a new array
    bool doubles = false;                  // whether the values are doubles; a new array is stored in this type
};

struct PlannedArray {
    ArrayInfo info;
    std::uint64_t tuples = 0; // number of points or cells of the imported file; values are in the order of this file
    bool doubles = false;     // whether the given values are doubles; info.doubles: whether they are stored as doubles
    // Point array that is interpolated from this cell array, as in an import; nullopt: none.
    std::optional<ArrayInfo> made;

    [[nodiscard]] std::uint64_t values() const { return tuples * static_cast<std::uint64_t>(info.components); }
};

// A step that has been checked and can be appended. It has the mesh and the coordinate set of the dataset's last step.
struct StepPlan {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::vector<PlannedArray> arrays; // in the order of the wanted arrays
    std::vector<std::string> added;   // names of arrays that the dataset does not have yet
    std::vector<std::string> lacking; // names of the dataset's arrays that have no values at this step
    std::vector<std::string> rounded; // names of arrays that are given as doubles and stored as floats
    std::uint64_t stored_bytes = 0;   // size of the step's values on the disk
};

// Checks a step before its values are known. Throws Error when the time, a name or a number of components is not
// allowed. Also throws Error when the last step is not on the mesh of the imported file, because values are in the
// order of that file.
[[nodiscard]] StepPlan plan_step(const Dataset& dataset, double time, std::span<const WantedArray> wanted);

// Returns the values of plan.arrays[i] in the order of the imported file, valid until the next call.
using ValuesOf = std::function<ciel::ValuesView(std::size_t i)>;

struct AppendedStep {
    std::size_t step = 0; // index of the new step
    StepPlan plan;        // the plan of the step, made while the dataset was locked
};

// Locks the dataset, plans the step and commits it. Throws Error as plan_step and Writer do, and when an array has
// another number of values than planned. Processes one array at a time, so that only one array must fit into memory.
AppendedStep append_step(const std::shared_ptr<Dataset>& dataset, double time, std::span<const WantedArray> wanted,
                         const ValuesOf& values_of);

// Appends the steps of `source` that are later than the last step of `dataset`. Returns the number of appended steps.
// Throws Error when there is no such step, or when a step is on a mesh that `dataset` does not have.
std::size_t append_dataset(const std::shared_ptr<Dataset>& dataset, const Dataset& source);

} // namespace server::store
