// What becomes of each VTK cell type: a standard cell, a standard cell with its mid-side nodes dropped, a prism with
// named faces, or nothing.
#pragma once

#include "ciel/types.hpp"

#include <array>

namespace ciel::importer {

struct CellShape {
    int vtk_type;
    CellType type;
    int corners;              // the first `corners` nodes are kept...
    int least_nodes;          // ...of at least so many
    const char* reduced_from; // null for a cell that keeps all its nodes: "quadratic tetrahedra"
};

// Null for cells that are not volumes, and for polyhedra, which have no shape of their own.
[[nodiscard]] const CellShape* find_shape(int vtk_type);

enum class Dimension { none, surface, volume };
[[nodiscard]] Dimension cell_dimension(int vtk_type);

} // namespace ciel::importer
