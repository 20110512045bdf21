// A mesh of any cells, ready to be cut: the paper's structure (section 2.2) built from the caller's arrays (appendix
// A).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/assemble.hpp"
#include "ciel/topology.hpp"

#include <memory>
#include <span>

namespace ciel {

// Report on the input. Ids are the caller's.
struct MeshReport {
    AssembleReport assembled;        // bad, reversed and inverted cells
    std::uint64_t skipped_cells = 0; // points, lines and surfaces among the cells
    std::uint64_t reduced_cells = 0; // of quadratic or higher order: only the corners are kept
    std::uint64_t bytes_copied = 0;  // of the caller's arrays
};

// Cells as vtkUnstructuredGrid has them (VTK User's Guide, "Cell types"): cell i has the points
// connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1]; offsets has one more entry than types.
struct VtkCells {
    ArrayView types;                 // C: VTK's numbers
    ArrayView offsets, connectivity; // C + 1, and any number

    // Faces of polyhedra. Up to VTK 9.3: faces[face_locations[i]] is the number of faces of cell i; then follow, for
    // each face, its number of points and its points. From VTK 9.4 on: cell i has the faces
    // cell_faces[cell_face_offsets[i]] to cell_faces[cell_face_offsets[i + 1] - 1], face f the points
    // face_connectivity[face_offsets[f]] to face_connectivity[face_offsets[f + 1] - 1].
    ArrayView face_locations{}, faces{};
    ArrayView cell_face_offsets{}, cell_faces{}, face_offsets{}, face_connectivity{};
};

// Immutable; copies share everything. Thread-safe. Points are stored as 32-bit float offsets from a double origin at
// the middle of the mesh.
class Mesh {
public:
    // Cell c has the faces cell_offset[c] to cell_offset[c + 1] - 1, face f the points face_vertex[face_offset[f]] to
    // face_vertex[face_offset[f + 1] - 1]. A face between two cells is listed once for each; any winding.
    // points: V x 3. Throws Error where sizes or types do not fit; cells that cannot be used are in the report.
    [[nodiscard]] static Mesh from_polyhedra(const ArrayView& points, const ArrayView& cell_offset,
                                             const ArrayView& face_offset, const ArrayView& face_vertex);
    // Each face is listed once, with the cells on its two sides, as in OpenFOAM. `neighbour` may be shorter than
    // `owner`; missing and negative entries mean a boundary face. Throws Error likewise.
    [[nodiscard]] static Mesh from_faces(const ArrayView& points, const ArrayView& face_offset,
                                         const ArrayView& face_vertex, const ArrayView& owner,
                                         const ArrayView& neighbour);
    // Throws Error likewise, also for a type that VTK does not have.
    [[nodiscard]] static Mesh from_cells(const ArrayView& points, const VtkCells& cells);
    // From a mesh that is already assembled: borrowed without a copy, ids in its own order. `keep_alive` owns the
    // arrays.
    [[nodiscard]] static Mesh from_stored(const FaceMeshView& faces, std::shared_ptr<const void> keep_alive);

    // The same cells with other points (V x 3, in the caller's order); the structure is shared. Throws Error on another
    // shape.
    [[nodiscard]] Mesh moved(const ArrayView& points) const;

    [[nodiscard]] std::size_t point_count() const; // the caller's
    [[nodiscard]] std::size_t cell_count() const;  // the caller's, including cells left out
    [[nodiscard]] const MeshReport& report() const;
    [[nodiscard]] const Topology& topology() const;   // lives as long as any copy of this mesh
    [[nodiscard]] const FaceMeshView& stored() const; // likewise

    // The caller's id of each stored vertex or cell; empty if the ids are equal.
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
