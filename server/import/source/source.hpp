// Interface of an opened input of any format: a series of time steps.
#pragma once

#include "import/source/array_selection.hpp"
#include "import/source/input_grids.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>
#include <vtkDataObject.h>
#include <vtkSmartPointer.h>

namespace server::importer {

struct SourceOptions {
    std::string plot3d; // the value of --plot3d: words for plot3d_restrict()
};

// Called during a long read. `share`: finished share of the read, in [0, 1]. May throw to cancel the read.
using ReadProgress = std::function<void(double share)>;

class Source {
public:
    virtual ~Source() = default;

    [[nodiscard]] virtual std::string format() const = 0;               // such as "OpenFOAM case"
    [[nodiscard]] virtual const std::vector<double>& times() const = 0; // ascending, at least one
    // Returns the data of one step. Later reads do not change the returned object. Throws Error that names the file.
    [[nodiscard]] virtual vtkSmartPointer<vtkDataObject> read(std::size_t step, const ReadProgress& progress) = 0;

    // Adds data that the source knows about the step that was read last: named cells, points to join, patch facts of
    // surfaces. `first`: running ids (joined_mesh.hpp) of the first point and the first cell of this source.
    virtual void add_known(InputGrids&, const RunningCounts& /*first*/) const {}

    // Returns the arrays that the reader lists for the step, without reading data. May include arrays that the step
    // lacks. Returns nullopt if the reader cannot list arrays.
    [[nodiscard]] virtual std::optional<std::vector<ArrayName>> listed_arrays(std::size_t) const {
        return std::nullopt;
    }
    // Returns a path such as "0.5/p"; empty if the file is not known.
    [[nodiscard]] virtual std::string file_of(const ArrayName& /*array*/, std::size_t /*step*/) const { return ""; }
    // Returns the files and directories from which this step and its mesh are read, without the index of the steps.
    // `names`: names of array files, without ".gz". If the format has a file for each array, array files with other
    // names are left out. Returns an empty list if the files of a step are not known.
    [[nodiscard]] virtual std::vector<std::filesystem::path> files_of(std::size_t /*step*/,
                                                                      const std::set<std::string>& /*names*/) const {
        return {};
    }
    // Returns whether the reader computes the array from other quantities in the file.
    [[nodiscard]] virtual bool is_derived(const ArrayName& /*array*/) const { return false; }
    [[nodiscard]] virtual std::map<std::string, std::string> units() const { return {}; } // by array name
    [[nodiscard]] virtual std::string length_units() const { return ""; }
    [[nodiscard]] virtual std::vector<std::string> notes() const { return {}; }
    // Returns one sentence for each part that could not be read at the step that was read last.
    [[nodiscard]] virtual std::vector<std::string> lost() const { return {}; }
};

} // namespace server::importer
