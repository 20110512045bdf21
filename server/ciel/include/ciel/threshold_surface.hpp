// Threshold: selects the cells whose values lie in a range, and makes the surface around them. Not in the paper. All
// functions may be called on any thread, and all results own their data.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/extract.hpp"

namespace ciel {

enum class InRange { all, any }; // which vertices of a cell must lie in the range

// Returns one flag per cell: 1 if all, or any, of its vertices lie in the range. `values`: one per vertex; throws Error
// on another number. The range includes both ends. NaN is outside. A cell without faces gets 0.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const FaceMeshView& mesh, ValuesView values,
                                                       std::array<double, 2> range, InRange vertices);
// Likewise, for the values of a field on the vertices. Reads the blocks whose range holds an end of `range` or in which
// vertices have no value. The flag of a cell without faces is unspecified.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const Field& field, std::array<double, 2> range,
                                                       InRange vertices);
// Returns the number of cells with a corner for whose value `counts` returns true. `counts` must return false for
// finite values. values: those that the field was made of. Reads the blocks in which vertices have no finite value.
[[nodiscard]] std::size_t count_cells_without_value(const Field& field, ValuesView values,
                                                    bool (*counts)(double value));
// Returns one flag per cell: 1 if its value lies in the range, which includes both ends. NaN is outside.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(ValuesView of_cells, std::array<double, 2> range);

struct CellFace { // a face, seen from one of its two cells
    Index face, cell;
};
// Returns the faces between a kept cell and a cell that is not kept, and the boundary faces of kept cells, in the order
// of face ids. `kept`: one flag per cell.
[[nodiscard]] std::vector<CellFace> threshold_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept);

// Returns the faces as polygons, wound outwards from the given cell of each. The points of the surface are mesh
// vertices (EdgePoint a == b), in the order of first use. Faces of fewer than three distinct vertices are left out.
[[nodiscard]] Surface face_surface(const FaceMeshView& mesh, std::span<const CellFace> faces);

[[nodiscard]] inline Surface threshold_surface(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    return face_surface(mesh, threshold_faces(mesh, kept));
}
// Returns a surface of the same polygons, but needs no list of all faces: the boundary faces of kept cells, then the
// faces inside the mesh, block by block. boundary: the boundary faces of the mesh. boxes: what block_boxes returned for
// its positions. Reads the blocks that have both kept cells and others. Of the blocks with only kept cells, reads those
// whose box touches the box of a block with a cell that is not kept. polygon_face is the index of the face in
// `boundary`, or `none` for a face inside the mesh. Uses all threads of the parallel loop. Throws Error when the
// arguments have other numbers of cells, vertices or blocks than the topology, and when a record is damaged.
[[nodiscard]] Surface threshold_surface(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                                        std::span<const std::uint8_t> kept);

// Returns the polygons of `surface`, a cut through a mesh, whose cells are kept. `kept`: one flag per cell; throws
// Error when it is too short. Throws Error for the result of clip_surface, whose new vertices have no entries in
// `points`: select cells before clipping.
[[nodiscard]] Surface polygons_of_cells(const Surface& surface, std::span<const std::uint8_t> kept);

} // namespace ciel
