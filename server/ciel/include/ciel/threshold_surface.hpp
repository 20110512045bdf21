// Threshold: selects the cells whose values lie in a range, and makes the surface around the selected cells. Not in the
// paper. Any thread may call the functions. The results own their data.
#pragma once

#include "ciel/block_ranges.hpp"
#include "ciel/extract.hpp"

namespace ciel {

enum class InRange { all, any }; // whether all vertices of a cell must lie in the range, or any vertex

// Returns one flag for each cell: 1 if all vertices (or any vertex) of the cell have a value in the range, else 0.
// `range`: [min, max], both included. NaN is outside every range. `values`: one for each vertex. Throws Error when
// `values` has another size. A cell without faces gets 0. Uses all threads of parallel_for.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const FaceMeshView& mesh, ValuesView values,
                                                       std::array<double, 2> range, InRange vertices);
// Returns the same flags for the values of a field. Reads only the blocks that have a vertex without a value, and the
// blocks whose range lies partly inside and partly outside `range`. The flag of a cell without faces is unspecified.
// Uses all threads of parallel_for.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const Field& field, std::array<double, 2> range,
                                                       InRange vertices);
// Returns the number of cells that have a vertex v with counts(values[v]) == true. `counts` must return false for
// finite values. `values`: the values from which the field was made. Throws Error when `values` has another size. Reads
// the blocks that have a vertex without a finite value. Uses all threads of parallel_for.
[[nodiscard]] std::size_t count_cells_without_value(const Field& field, ValuesView values,
                                                    bool (*counts)(double value));
// Returns one flag for each cell: 1 if the value of the cell lies in the range, else 0. `of_cells`: one value for each
// cell. `range`: [min, max], both included. NaN is outside every range.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(ValuesView of_cells, std::array<double, 2> range);

// A face, seen from one of its two cells.
struct CellFace {
    Index face, cell;
};
// Returns the faces between a kept cell and a cell that is not kept, and the boundary faces of kept cells, in the order
// of face ids. CellFace::cell is the kept cell. REQUIRES: `kept` has one flag for each cell. Throws Error when an index
// of the mesh is out of range.
[[nodiscard]] std::vector<CellFace> threshold_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept);

// Returns the faces as polygons, wound outwards from CellFace::cell. The points of the surface are mesh vertices
// (EdgePoint with a == b), in the order of first use. Faces of fewer than three distinct vertices are left out. Throws
// Error when an index of the mesh is out of range. REQUIRES: the faces exist.
[[nodiscard]] Surface face_surface(const FaceMeshView& mesh, std::span<const CellFace> faces);

// Whether a surface has the faces of fewer than three distinct vertices, which collapsed cells have.
enum class CollapsedFaces { leave_out, keep };

// Returns the faces of threshold_faces as polygons: the surface around the kept cells.
[[nodiscard]] inline Surface threshold_surface(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    return face_surface(mesh, threshold_faces(mesh, kept));
}
// Returns a surface of the same polygons, without the need for a list of all faces of the mesh. The polygons are the
// boundary faces of kept cells, and then the faces inside the mesh, block by block. `boundary`: the boundary faces of
// the mesh; faces between two cells are ignored. `boxes`: the result of block_boxes for the positions of the mesh.
// polygon_face is the index of the face in `boundary`, or `none` for a face inside the mesh.
// Reads the blocks that have both kept cells and other cells. Also reads a block of only kept cells if the box of this
// block touches the box of a block with a cell that is not kept. Uses all threads of parallel_for. Throws Error when
// the arguments have other numbers of cells, vertices or blocks than the topology, and when a record is damaged.
[[nodiscard]] Surface threshold_surface(const Topology& topology, const FaceMeshView& boundary, const BlockBoxes& boxes,
                                        std::span<const std::uint8_t> kept,
                                        CollapsedFaces collapsed = CollapsedFaces::leave_out);

// Returns the polygons of `surface` whose cells are kept. `surface`: a cut through a mesh. `kept`: one flag for each
// cell. Throws Error when a polygon's cell has no flag. Also throws Error if clip_surface added vertices, because new
// vertices have no entries in `points`; select cells before clipping.
[[nodiscard]] Surface polygons_of_cells(const Surface& surface, std::span<const std::uint8_t> kept);

} // namespace ciel
