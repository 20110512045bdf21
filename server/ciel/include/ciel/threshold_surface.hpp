// Threshold: whole cells whose values lie in a range, and the surface around them. Not in the paper; uses its
// mate_polyhedron (section 2.2). Any thread; all results own their data.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

enum class InRange { all, any }; // which vertices of a cell must lie in the range

// Returns one flag per cell. `values`: one per vertex; throws Error on another number. The range includes both ends,
// and never NaN. A cell without faces is not kept.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const FaceMeshView& mesh, std::span<const float> values,
                                                       std::array<double, 2> range, InRange vertices);
// The same with one value per cell.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(std::span<const float> of_cells, std::array<double, 2> range);

struct CellFace { // a face as a side of one of its cells
    Index face, cell;
};
// Returns the faces of kept cells whose other half-edge (mate_polyhedron) is not of a kept cell: faces to other cells
// and boundary faces. In the order of faces.
[[nodiscard]] std::vector<CellFace> threshold_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept);

// Returns the faces as polygons, wound outwards from their cell. Points are mesh vertices (a == b), in the order of
// their first use. Faces of fewer than three distinct vertices are left out.
[[nodiscard]] Surface face_surface(const FaceMeshView& mesh, std::span<const CellFace> faces);

[[nodiscard]] inline Surface threshold_surface(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    return face_surface(mesh, threshold_faces(mesh, kept));
}

// Returns the polygons of kept cells of a cut through the mesh. `kept`: one flag per cell; throws Error when a
// polygon's cell has none. Throws Error for a clipped surface (clip_surface.hpp), whose new vertices have no points:
// choose cells before clipping.
[[nodiscard]] Surface polygons_of_cells(const Surface& surface, std::span<const std::uint8_t> kept);

} // namespace ciel
