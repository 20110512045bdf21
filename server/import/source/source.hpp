// Interface of an opened input of any format: a series of time steps.
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

// Called during a long read with the share that is done, in [0, 1]. May throw to cancel the read.
using ReadProgress = std::function<void(double share)>;

class Source {
public:
    virtual ~Source() = default;

    [[nodiscard]] virtual std::string format() const = 0;               // such as "OpenFOAM case"
    [[nodiscard]] virtual const std::vector<double>& times() const = 0; // ascending, at least one
    // Returns the data of one step. Later reads do not change it. Throws Error naming the file.
    [[nodiscard]] virtual vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) = 0;

    // Adds facts about the step read last: named cells, points to join, facts of surfaces. `first`: the running ids of
    // the source's first point and cell.
    virtual void add_known(DataSets&, const RunningCounts& /*first*/) const {}

    // Lists the arrays of a step without reading its data. May list arrays that the step lacks. Returns nullopt if the
    // reader cannot list arrays.
    [[nodiscard]] virtual std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const {
        return std::nullopt;
    }
    // Returns the file that an array comes from, such as "0.5/p"; empty if not known.
    [[nodiscard]] virtual std::string file_of(const ArrayName& /*array*/, std::size_t /*step*/) const { return ""; }
    // Whether the reader computes the array from other quantities in the file.
    [[nodiscard]] virtual bool is_derived(const ArrayName& /*array*/) const { return false; }
    [[nodiscard]] virtual std::map<std::string, std::string> units() const { return {}; } // by array name
    [[nodiscard]] virtual std::string length_units() const { return ""; }
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
    // Returns a sentence for each part of the step read last that could not be read.
    [[nodiscard]] virtual std::vector<std::string> lost() const { return {}; }
};

} // namespace ciel::importer
