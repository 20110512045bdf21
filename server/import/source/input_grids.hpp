// Converts the output of a reader, a tree of VTK data objects, to lists of named input grids.
#pragma once

#include "ciel/types.hpp"
#include "store/dataset.hpp"

#include <string>
#include <utility>
#include <vector>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

namespace server::importer {

struct InputGrid { // a leaf of the tree: a volume, a surface or a zone
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
    bool own_values = true; // false: the solver gives no values on this surface (faceZones)
    int whole = -1;         // the same number in all pieces of one mesh; -1: not a piece
    store::PatchFacts facts = {};
};

using PointPairs = std::vector<std::pair<ciel::Index, ciel::Index>>; // pairs of running point ids (joined_mesh.hpp)

struct RunningCounts {
    ciel::Index points = 0, cells = 0;
};

struct NamedCells {
    std::string name;
    std::vector<ciel::Index> cells; // running ids (joined_mesh.hpp)
};

struct InputGrids {
    std::vector<InputGrid> volumes;      // each holds at least one cell of dimension 3
    std::vector<InputGrid> surfaces;     // patches and side sets: cells of dimension 2, no cells of dimension 3
    std::vector<InputGrid> zones;        // each is a named copy of cells of the volumes
    std::vector<NamedCells> named_cells; // zones that the source gives as lists of cell ids

    // Only OpenFOAM's reader sets these members, from the processor patches. same_points: points to join. joined_faces:
    // number of faces that two pieces share. single_faces: number of faces without a counterpart on another piece.
    PointPairs same_points;
    std::uint64_t joined_faces = 0, single_faces = 0;
};

// Collects the input grids in the output of a reader. Leaves out grids without cells of dimension 2 or 3. Makes equal
// names unique: first it adds the names of parent VTK blocks, then a number. Unnamed pieces of one mesh share one name.
[[nodiscard]] InputGrids collect_input_grids(vtkDataObject* data);
void require_volumes(const InputGrids& input_grids);

} // namespace server::importer
