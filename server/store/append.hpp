// Appends steps to a dataset, for `ciel append` and for uploads to a server. Both check a step by the same rules and
// fail with the same messages.
#pragma once

#include "store/dataset.hpp"

#include <functional>

namespace ciel::store {

// An array that a caller wants to append: "p" for values on points, "cell:p" for values on cells.
struct WantedArray {
    std::string name;
    std::optional<std::size_t> components; // default: as many as the array has in the dataset, 1 for a new array
    bool doubles = false;                  // whether the values are doubles; a new array is stored in their type
};

struct PlannedArray {
    ArrayInfo info;
    std::uint64_t tuples = 0; // points or cells of the imported file; values come in their order
    bool doubles = false;     // whether the values come as doubles; info.doubles: whether they are stored as doubles
    std::optional<ArrayInfo> made; // point array to make from this cell array, as an import does

    [[nodiscard]] std::uint64_t values() const { return tuples * static_cast<std::uint64_t>(info.components); }
};

// A checked step to append. It has the mesh and the coordinates of the dataset's last step.
struct StepPlan {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::vector<PlannedArray> arrays; // in the order of the wanted arrays
    std::vector<std::string> added;   // names of arrays that the dataset does not have yet
    std::vector<std::string> lacking; // names of the dataset's arrays that have no values at this step
    std::vector<std::string> rounded; // names of arrays that come in doubles and are stored in floats
    std::uint64_t stored_bytes = 0;   // size of the step's values on disk
};

// Checks a step before its values are known. Throws Error for a time that is not later than the last step, a name that
// a new array cannot have, another number of components than the array has, or an array that is given twice. Also
// throws Error when the last step is not on the mesh of the imported file, because values come in the order of that
// file.
[[nodiscard]] StepPlan plan_step(const Dataset& dataset, double time, std::span<const WantedArray> wanted);

// Returns the values of plan.arrays[i] in the order of the imported file. They must stay valid until the next call.
using ValuesOf = std::function<ValuesView(std::size_t i)>;

struct AppendedStep {
    std::size_t step = 0; // index of the new step
    StepPlan plan;        // plan made under the lock and carried out
};

// Locks the dataset, plans the step and commits it. Throws Error as plan_step and Writer do, and when an array has
// another number of values than planned. Processes one array at a time, so the step need not fit into memory.
AppendedStep append_step(const std::shared_ptr<Dataset>& dataset, double time, std::span<const WantedArray> wanted,
                         const ValuesOf& values_of);

// Appends the steps of `source` that are later than the last step of `dataset`. Returns their number. Throws Error when
// there are none, or when one is on a mesh that `dataset` does not have.
std::size_t append_dataset(const std::shared_ptr<Dataset>& dataset, const Dataset& source);

} // namespace ciel::store
