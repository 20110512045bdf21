// The caller's cells, whatever their form, as the polyhedra lists that Algorithm 5 takes (paper, appendix A).
#pragma once

#include "ciel/mesh.hpp"

#include <vector>

namespace ciel {

struct PolyhedraLists {
    Vec3d origin{};
    std::vector<float> positions;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> cell_offset{0}, face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> source_cell; // the caller's; empty where all are here
    std::uint64_t skipped = 0, reduced = 0;

    [[nodiscard]] PolyhedraView view() const {
        return {origin, positions, cell_types, cell_offset, face_offset, face_vertex};
    }
    [[nodiscard]] std::uint64_t bytes() const;
};

// points: V x 3. Throws Error for other columns, and for more points than 32-bit ids have.
void put_points(const ArrayView& points, PolyhedraLists& lists);
// Offsets from `origin`.
[[nodiscard]] std::vector<float> positions_from(const ArrayView& points, const Vec3d& origin);

// After put_points. Throw Error where sizes do not fit or an id is out of range; cells without a use are counted.
void put_polyhedra(const ArrayView& cell_offset, const ArrayView& face_offset, const ArrayView& face_vertex,
                   PolyhedraLists& lists);
void put_owner_faces(const ArrayView& face_offset, const ArrayView& face_vertex, const ArrayView& owner,
                     const ArrayView& neighbour, PolyhedraLists& lists);
void put_vtk_cells(const VtkCells& cells, PolyhedraLists& lists);

// The standard type that the last cell's faces make it, whatever it was called.
[[nodiscard]] CellType type_of_last_cell(const PolyhedraLists& lists);

} // namespace ciel
