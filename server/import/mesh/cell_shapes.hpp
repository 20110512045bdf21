// Maps VTK cell types to CIEL cell types. Higher-order cells keep only their corners. Pentagonal and hexagonal prisms
// become polyhedra.
#pragma once

#include "ciel/types.hpp"

#include <array>

namespace ciel::importer {

struct CellShape {
    int vtk_type;
    CellType type;
    int corners;              // number of corners, the first nodes of the VTK cell; other nodes are dropped
    int least_nodes;          // a cell of this type with fewer nodes is damaged
    const char* reduced_from; // plural name for notes, such as "quadratic tetrahedra"; null if all nodes are kept
};

// Returns null for polyhedra, convex point sets, and VTK types that are not volumes.
[[nodiscard]] const CellShape* find_shape(int vtk_type);

enum class Dimension { none, surface, volume };
[[nodiscard]] Dimension cell_dimension(int vtk_type);

} // namespace ciel::importer
