// Cells whose values lie in a range, kept whole, and the surface around them: a threshold. Not in the paper, but by its
// mate_polyhedron (section 2.2). Any thread; all results own what they have.
#pragma once

#include "ciel/extract.hpp"

namespace ciel {

enum class InRange { all, any }; // of a cell's vertices

// One flag per cell. `values`: one per vertex; throws Error on another number. Both ends belong to the range; NaN is in
// none. A cell without faces is not kept.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(const FaceMeshView& mesh, std::span<const float> values,
                                                       std::array<double, 2> range, InRange vertices);
// Likewise where each cell has a value of its own.
[[nodiscard]] std::vector<std::uint8_t> cells_in_range(std::span<const float> of_cells, std::array<double, 2> range);

struct CellFace { // a face as a side of one of its cells
    Index face, cell;
};
// The faces between a kept cell and one that is not, or nothing: those whose other half-edge (mate_polyhedron) is not
// of a kept cell. In the order of faces.
[[nodiscard]] std::vector<CellFace> threshold_faces(const FaceMeshView& mesh, std::span<const std::uint8_t> kept);

// Faces as polygons, wound to look out of their cell; points are mesh vertices (a == b), in the order of their first
// use. Faces of fewer than three distinct vertices are left out.
[[nodiscard]] Surface face_surface(const FaceMeshView& mesh, std::span<const CellFace> faces);

[[nodiscard]] inline Surface threshold_surface(const FaceMeshView& mesh, std::span<const std::uint8_t> kept) {
    return face_surface(mesh, threshold_faces(mesh, kept));
}

// The polygons of kept cells, of a cut through the mesh; `kept`: a flag per cell. Throws Error for a surface that was
// clipped (clip_surface.hpp): its new vertices have no points to keep. So cells are chosen first.
[[nodiscard]] Surface polygons_of_cells(const Surface& surface, std::span<const std::uint8_t> kept);

} // namespace ciel
