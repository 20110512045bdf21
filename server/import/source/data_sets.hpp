// What a reader gave, flattened: the data sets that hold cells, with names.
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
    bool own_values = true; // of a surface: its arrays say more than the cells behind it
    int whole = -1;         // pieces of one mesh have the same one; -1: a mesh of its own
    store::PatchFacts facts = {};
};

using PointPairs = std::vector<std::pair<Index, Index>>; // running points (joined_mesh.hpp)

struct RunningCounts {
    Index points = 0, cells = 0;
};

struct NamedCells {
    std::string name;
    std::vector<Index> cells; // running
};

struct DataSets {
    std::vector<DataSet> volumes;        // hold at least one cell of dimension 3 (and maybe others)
    std::vector<DataSet> surfaces;       // only cells of dimension 2: patches, side sets
    std::vector<DataSet> zones;          // copies of cells that the volumes have, under a name
    std::vector<NamedCells> named_cells; // the same by their ids

    // Where a mesh was cut and the source knows along what: points that are one, faces that lie between two pieces, and
    // faces whose other side is missing.
    PointPairs same_points;
    std::uint64_t joined_faces = 0, single_faces = 0;
};

// Empty data sets and those of points and lines are left out. Names are unique: a data set's own name, with its
// parents' where that is not enough; but pieces without a name of their own have that of their whole.
[[nodiscard]] DataSets collect_data_sets(vtkDataObject* data);
// Throws Error where there is nothing to cut.
void require_volumes(const DataSets& data_sets);

} // namespace ciel::importer
