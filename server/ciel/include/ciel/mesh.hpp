// Mesh: a mesh of cells of any shape, ready to be cut. Builds the paper's structure (section 2.2) from the caller's
// arrays (appendix A).
#pragma once

#include "ciel/array_view.hpp"
#include "ciel/assemble.hpp"
#include "ciel/topology.hpp"

#include <memory>
#include <span>

namespace ciel {

// Reports what was left out, changed or copied when a Mesh was made. Ids are the caller's ids.
struct MeshReport {
    AssembleReport assembled;        // bad, reversed and inverted cells
    std::uint64_t skipped_cells = 0; // points, lines and surfaces, which were left out
    std::uint64_t reduced_cells = 0; // quadratic and higher-order cells, reduced to their corners
    // Bytes of the temporary lists into which the caller's arrays were copied, and of the positions that moved()
    // stored. The lists are freed after the mesh is built. Other data of the built mesh is not counted.
    std::uint64_t bytes_copied = 0;
};

// Cells in the arrays of a vtkUnstructuredGrid (VTK User's Guide, "Cell types"). C: number of cells. Cell i has the
// points connectivity[offsets[i]] to connectivity[offsets[i + 1] - 1].
struct VtkCells {
    ArrayView types;                 // C: VTK's number of each cell's type
    ArrayView offsets, connectivity; // offsets: C + 1

    // Faces of polyhedra. Up to VTK 9.3: faces[face_locations[i]] is the number of faces of cell i. Then follow, for
    // each face, the number of its points and the points. From VTK 9.4 on: cell i has the faces
    // cell_faces[cell_face_offsets[i]] to cell_faces[cell_face_offsets[i + 1] - 1]. Face f has the points
    // face_connectivity[face_offsets[f]] to face_connectivity[face_offsets[f + 1] - 1].
    ArrayView face_locations{}, faces{};
    ArrayView cell_face_offsets{}, cell_faces{}, face_offsets{}, face_connectivity{};
};

class CellFits; // cell_fits.hpp

// Immutable; copies share all data. Thread-safe. Stores points as floats if these are equal to the caller's numbers,
// else as doubles. Surfaces store positions as float offsets from stored().surface_origin, the middle of the mesh.
class Mesh {
public:
    // from_polyhedra, from_faces, from_cells and moved keep nothing of the caller's arrays, which may be freed after
    // the call. They use all threads of parallel_for. Any thread may call them.

    // Makes a mesh of cells that are lists of faces. `points`: V x 3. Cell c has the faces cell_offset[c] to
    // cell_offset[c + 1] - 1. Face f has the points face_vertex[face_offset[f]] to face_vertex[face_offset[f + 1] - 1],
    // in any winding. A face between two cells is listed once for each cell. Throws Error when an array has a wrong
    // size or number type. Unusable cells are left out; report() counts them.
    [[nodiscard]] static Mesh from_polyhedra(const ArrayView& points, const ArrayView& cell_offset,
                                             const ArrayView& face_offset, const ArrayView& face_vertex);
    // Makes a mesh of faces that are listed once, as in OpenFOAM. `points`: V x 3. Face f has the points
    // face_vertex[face_offset[f]] to face_vertex[face_offset[f + 1] - 1], and the cells owner[f] and neighbour[f].
    // `neighbour` may be shorter than `owner`; a missing or negative entry means a boundary face. Throws
    // Error, and leaves out cells, as from_polyhedra does.
    [[nodiscard]] static Mesh from_faces(const ArrayView& points, const ArrayView& face_offset,
                                         const ArrayView& face_vertex, const ArrayView& owner,
                                         const ArrayView& neighbour);
    // Makes a mesh from the arrays of a vtkUnstructuredGrid. `points`: V x 3. Throws Error when an array has a wrong
    // size or number type, or when VTK has no such cell type. Unusable cells are left out; report() counts them.
    [[nodiscard]] static Mesh from_cells(const ArrayView& points, const VtkCells& cells);
    // Makes a mesh from faces that are already matched, without a copy. Loads all positions. Ids are the ids of
    // `faces`. Throws Error when `faces` has no owner, and when the arrays break the contract of FaceMeshView.
    [[nodiscard]] static Mesh from_stored(const FaceMeshView& faces);

    // Returns a mesh with the same cells and other positions. `points`: V x 3, in the caller's order. Shares the
    // topology. Throws Error when `points` has another shape.
    [[nodiscard]] Mesh moved(const ArrayView& points) const;

    [[nodiscard]] std::size_t point_count() const; // points in the caller's arrays
    [[nodiscard]] std::size_t cell_count() const;  // cells in the caller's arrays, including those left out
    [[nodiscard]] const MeshReport& report() const;
    // Return the topology and the arrays of this mesh. Copies of both may outlive the mesh.
    [[nodiscard]] const Topology& topology() const;
    [[nodiscard]] const FaceMeshView& stored() const;
    // Returns the CellFits that all fields on this mesh share.
    [[nodiscard]] const std::shared_ptr<CellFits>& cell_fits() const;

    // Return the caller's id of each stored vertex, and of each stored cell. Empty in a mesh made by from_stored, where
    // stored ids are the caller's ids.
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
