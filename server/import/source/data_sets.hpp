// A reader's output as flat lists of named data sets.
#pragma once

#include "ciel/types.hpp"
#include "store/dataset.hpp"

#include <string>
#include <utility>
#include <vector>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

namespace ciel::importer {

struct DataSet {
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
    bool own_values = true; // false for a surface whose values are copied from the cells behind it
    int whole = -1;         // pieces of one mesh have the same number; -1: not a piece
    store::PatchFacts facts = {};
};

using PointPairs = std::vector<std::pair<Index, Index>>; // pairs of running point ids (joined_mesh.hpp)

struct RunningCounts {
    Index points = 0, cells = 0;
};

struct NamedCells {
    std::string name;
    std::vector<Index> cells; // running ids
};

struct DataSets {
    std::vector<DataSet> volumes;        // hold at least one cell of dimension 3 (and maybe others)
    std::vector<DataSet> surfaces;       // hold cells of dimension 2 and none of 3: patches, side sets
    std::vector<DataSet> zones;          // named copies of cells of the volumes
    std::vector<NamedCells> named_cells; // zones given by cell ids

    // Cuts that the source knows (OpenFOAM's processor patches): points to join, number of faces between two pieces,
    // and number of faces whose other side is missing.
    PointPairs same_points;
    std::uint64_t joined_faces = 0, single_faces = 0;
};

// Leaves out data sets without cells of dimension 2 or 3. Equal names are made unique by the names of parent blocks,
// then by a number. Unnamed pieces share the name of their whole.
[[nodiscard]] DataSets collect_data_sets(vtkDataObject* data);
// Throws Error if there are no volumes.
void require_volumes(const DataSets& data_sets);

} // namespace ciel::importer
