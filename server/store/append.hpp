// The rules of appending: what a step may hold, and in which order its values come. `ciel append` and uploads to a
// server refuse the same things with the same sentences.
#pragma once

#include "store/dataset.hpp"

#include <functional>

namespace ciel::store {

// An array as somebody wants to append it: "p", or "cell:p" for values of cells.
struct WantedArray {
    std::string name;
    std::optional<std::size_t> components; // not given: as many as the array has already, or 1
};

struct PlannedArray {
    ArrayInfo info;
    std::uint64_t tuples = 0;      // values come in the order of the imported file's points or cells
    std::optional<ArrayInfo> made; // point values made from these cell values, as an import makes them

    [[nodiscard]] std::uint64_t values() const { return tuples * static_cast<std::uint64_t>(info.components); }
};

// A step on the mesh and the coordinates of the last one.
struct StepPlan {
    double time = 0;
    std::size_t mesh = 0, coordinates = 0;
    std::vector<PlannedArray> arrays; // in the order in which they are wanted
    std::vector<std::string> added;   // arrays that the dataset does not have yet
    std::vector<std::string> lacking; // arrays of the dataset that have no values at this step
    std::uint64_t stored_bytes = 0;   // of all its values, as they are stored
};

// Throws Error, before any value is needed: a time that is not later than the last, a name that a new array cannot
// have, other components than the array has, an array twice, a dataset whose last mesh does not have the imported
// file's order.
[[nodiscard]] StepPlan plan_step(const Dataset& dataset, double time, std::span<const WantedArray> wanted);

// The values of plan.arrays[i], in the imported file's order; valid until the next call.
using ValuesOf = std::function<std::span<const float>(std::size_t i)>;

struct AppendedStep {
    std::size_t step = 0; // its number
    StepPlan plan;        // as it was carried out
};

// Locks the dataset, plans the step anew and commits it. Throws as plan_step and Writer do, and when the values do not
// have the planned number. At most two arrays are in memory at a time.
AppendedStep append_step(const std::shared_ptr<Dataset>& dataset, double time, std::span<const WantedArray> wanted,
                         const ValuesOf& values_of);

// Appends the steps of `source` that are later than the dataset's last. Throws Error when they are on another mesh, or
// when there are none. Returns how many they were.
std::size_t append_dataset(const std::shared_ptr<Dataset>& dataset, const Dataset& source);

} // namespace ciel::store
