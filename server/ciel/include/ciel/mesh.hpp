// Mesh: a mesh of any cells, ready to be cut. Builds the paper's structure (section 2.2) from the caller's arrays
// (appendix A).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/assemble.hpp"
#include "ciel/topology.hpp"

#include <memory>
#include <span>

namespace ciel {

// What was left out, changed or copied when a Mesh was made. Ids are the caller's.
struct MeshReport {
    AssembleReport assembled;        // bad, reversed and inverted cells
    std::uint64_t skipped_cells = 0; // cells without volume: points, lines and surfaces
    std::uint64_t reduced_cells = 0; // cells of quadratic or higher order, of which only the corners are kept
    std::uint64_t bytes_copied = 0;  // bytes of the caller's arrays that had to be copied
};

// Cells as vtkUnstructuredGrid has them (VTK User's Guide, "Cell types"): cell i has the points
// connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1]; offsets has one more entry than types.
struct VtkCells {
    ArrayView types;                 // VTK's number of each cell's type
    ArrayView offsets, connectivity; // offsets: one entry per cell and one more, into connectivity

    // Faces of polyhedra. Up to VTK 9.3: faces[face_locations[i]] is the number of faces of cell i; then follow, for
    // each face, its number of points and its points. From VTK 9.4 on: cell i has the faces
    // cell_faces[cell_face_offsets[i]] to cell_faces[cell_face_offsets[i + 1] - 1], face f the points
    // face_connectivity[face_offsets[f]] to face_connectivity[face_offsets[f + 1] - 1].
    ArrayView face_locations{}, faces{};
    ArrayView cell_face_offsets{}, cell_faces{}, face_offsets{}, face_connectivity{};
};

class CellFits; // cell_fits.hpp

// Immutable; copies share everything. Thread-safe. Stores points as floats if these are equal to the caller's numbers,
// else as doubles. Positions of surfaces are floats relative to stored().surface_origin, the middle of the mesh.
class Mesh {
public:
    // Cell c has the faces cell_offset[c] to cell_offset[c + 1] - 1. Face f has the points face_vertex[face_offset[f]]
    // to face_vertex[face_offset[f + 1] - 1], in any winding. A face between two cells is listed once for each cell.
    // points: V x 3. Throws Error when an array has a wrong size or number type. report() counts cells left out.
    [[nodiscard]] static Mesh from_polyhedra(const ArrayView& points, const ArrayView& cell_offset,
                                             const ArrayView& face_offset, const ArrayView& face_vertex);
    // Each face is listed once, with the cells on its two sides, as in OpenFOAM. `neighbour` may be shorter than
    // `owner`; missing and negative entries mean a boundary face. Throws Error when an array has a wrong size or number
    // type. report() counts cells left out.
    [[nodiscard]] static Mesh from_faces(const ArrayView& points, const ArrayView& face_offset,
                                         const ArrayView& face_vertex, const ArrayView& owner,
                                         const ArrayView& neighbour);
    // points: V x 3. Throws Error when an array has a wrong size or number type, or VTK has no such cell type.
    // report() counts cells left out.
    [[nodiscard]] static Mesh from_cells(const ArrayView& points, const VtkCells& cells);
    // Uses an assembled mesh without a copy. `keep_alive` owns its arrays. Ids are those of `faces`.
    [[nodiscard]] static Mesh from_stored(const FaceMeshView& faces, std::shared_ptr<const void> keep_alive);

    // Returns a mesh with the same cells and new positions of the points (V x 3, in the caller's order). Shares the
    // topology. Throws Error on another shape.
    [[nodiscard]] Mesh moved(const ArrayView& points) const;

    [[nodiscard]] std::size_t point_count() const; // points in the caller's arrays
    [[nodiscard]] std::size_t cell_count() const;  // cells in the caller's arrays, including those left out
    [[nodiscard]] const MeshReport& report() const;
    [[nodiscard]] const Topology& topology() const;   // lives as long as any copy of this mesh
    [[nodiscard]] const FaceMeshView& stored() const; // lives as long as any copy of this mesh
    // Returns the CellFits that all fields on this mesh share.
    [[nodiscard]] const std::shared_ptr<CellFits>& cell_fits() const;

    // Returns the caller's id of each stored vertex or cell; empty if stored ids and the caller's ids are equal.
    [[nodiscard]] std::span<const Index> original_vertex() const;
    [[nodiscard]] std::span<const Index> original_cell() const;

private:
    struct State;
    explicit Mesh(std::shared_ptr<const State> state) : state_(std::move(state)) {}
    template <class Put>
    static Mesh make(const ArrayView& points, std::size_t cells, const Put& put);
    std::shared_ptr<const State> state_;
};

} // namespace ciel
