// What a reader gave, flattened: the data sets that hold cells, with names.
#pragma once

#include <string>
#include <vector>
#include <vtkDataObject.h>
#include <vtkDataSet.h>
#include <vtkSmartPointer.h>

namespace ciel::importer {

struct Block {
    std::string name;
    vtkSmartPointer<vtkDataSet> data;
    bool own_values = true; // of a surface: its arrays say more than the cells behind it
    int whole = -1;         // pieces of one mesh have the same one; -1: a mesh of its own
};

struct Blocks {
    std::vector<Block> volumes;  // hold at least one cell of dimension 3 (and maybe others)
    std::vector<Block> surfaces; // only cells of dimension 2: patches, side sets
    std::vector<Block> zones;    // copies of cells that the volumes have, under a name
};

// Empty data sets and those of points and lines are left out. Names are unique: a data set's own name, with its
// parents' where that is not enough; but pieces without a name of their own have that of their whole.
[[nodiscard]] Blocks collect_blocks(vtkDataObject* data);
// Throws Error where there is nothing to cut.
void require_volumes(const Blocks& blocks);

} // namespace ciel::importer
