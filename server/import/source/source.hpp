// An input as a series of steps, whatever its format.
#pragma once

#include "import/source/array_selection.hpp"
#include "import/source/data_sets.hpp"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

namespace ciel::importer {

struct SourceOptions {
    std::string plot3d; // words for plot3d_restrict()
};

// What a long read tells: a share in [0, 1]. May throw to cancel.
using ReadProgress = std::function<void(double share)>;

class Source {
public:
    virtual ~Source() = default;

    [[nodiscard]] virtual std::string format() const = 0;               // "OpenFOAM case"
    [[nodiscard]] virtual const std::vector<double>& times() const = 0; // ascending, at least one
    // The data of one step; the caller keeps it as long as it likes. Throws Error naming the file.
    [[nodiscard]] virtual vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) = 0;

    // Adds what the source knows of the step read last besides its data: named cells, points that are one, facts of
    // surfaces. `first`: where its running points and cells begin.
    virtual void add_known(DataSets&, const RunningCounts& /*first*/) const {}

    // What a step is said to hold before its data is read, or more; nullopt where the reader cannot tell.
    [[nodiscard]] virtual std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const {
        return std::nullopt;
    }
    // Where an array of the step read last comes from, as a user would name it; empty where that is the only input.
    [[nodiscard]] virtual std::string file_of(const ArrayName& /*array*/, std::size_t /*step*/) const { return ""; }
    // Whether the file has other quantities, from which the reader computes it.
    [[nodiscard]] virtual bool is_derived(const ArrayName& /*array*/) const { return false; }
    [[nodiscard]] virtual std::map<std::string, std::string> units() const { return {}; } // by array name
    [[nodiscard]] virtual std::string length_units() const { return ""; }
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
    // Sentences on what the step read last should hold and does not: a piece that cannot be read.
    [[nodiscard]] virtual std::vector<std::string> lost() const { return {}; }
};

} // namespace ciel::importer
