// Converts the caller's cells, in any form, to the polyhedra lists that Algorithm 5 takes (paper, appendix A).
#pragma once

#include "ciel/mesh.hpp"
#include "mesh/mesh_points.hpp"

#include <vector>

namespace ciel::detail {

struct PolyhedraLists {
    MeshPoints points;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> source_cell; // cell of these lists -> caller's cell
    std::uint64_t skipped = 0, reduced = 0;

    [[nodiscard]] PolyhedraView view() const {
        return {{}, points.view(), cell_types, cell_offset, face_offset, face_vertex};
    }
    [[nodiscard]] std::uint64_t bytes() const;
};

// Throws Error if there are not three columns, or too many points for 32-bit ids.
void put_points(const ArrayView& points, PolyhedraLists& lists);

// The following three functions append cells; call put_points before them. They throw Error when the sizes of arrays or
// the offsets are not valid, or when a face or cell id is out of range. A vertex id that does not fit 32 bits becomes
// `none`, which assemble() reports. put_vtk_cells leaves out cells without volume and convex
// point sets, counts them in `skipped`, and throws Error for types that CIEL does not read.
void put_polyhedra(const ArrayView& cell_offset, const ArrayView& face_offset, const ArrayView& face_vertex,
                   PolyhedraLists& lists);
void put_owner_faces(const ArrayView& face_offset, const ArrayView& face_vertex, const ArrayView& owner,
                     const ArrayView& neighbour, PolyhedraLists& lists);
void put_vtk_cells(const VtkCells& cells, PolyhedraLists& lists);

} // namespace ciel::detail
