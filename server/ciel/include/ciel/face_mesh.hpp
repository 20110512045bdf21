// FaceMesh: a mesh as a list of faces, each with an owner cell and a neighbor cell. The import makes a FaceMesh, and
// Topology is built from it. A FaceMesh is the result of the first half of the paper's Algorithm 5 (appendix A), which
// finds the two cells of each face.
#pragma once

#include "ciel/checked_array.hpp"
#include "ciel/value_source.hpp"
#include "ciel/values_view.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ciel {

// View of a FaceMesh. V: number of vertices, F: number of faces, C: number of cells. A view with an owner (keep_alive)
// may be kept and copied. A view without an owner can only be passed to functions: an object that keeps the view throws
// Error.
// A face between two cells is stored once. The right-hand normal of its loop points out of `owner` into `neighbour`.
// owner < neighbour; on the boundary, `neighbour` is `none`. A loop may repeat vertex ids (collapsed cells).
// Cells are in the order of a space-filling curve. Faces are sorted by owner. Vertices are in the order of their first
// use in the faces; unused vertices are last. Views with the faces of numbered_faces.hpp may have another order of
// faces.
// Each index is checked when it is read, because the arrays may be in a mapped file. Positions and types are not
// checked, because any value is harmless.
struct FaceMeshView {
    using Offsets = CheckedArray<std::uint64_t>;

    Vec3d origin{};                           // is added to every position
    Vec3d surface_origin{};                   // surfaces store positions as float offsets from this point near the mesh
    ValuesView positions;                     // 3 V: x, y, z of each vertex, as offsets from origin
    std::span<const std::uint8_t> cell_types; // C: a CellType for each cell
    Offsets face_offset;                      // F + 1: index of the first vertex of face f in face_vertex
    Ids face_vertex;                          // vertex ids, loop by loop
    Ids owner;                                // F: cell id
    OptionalIds neighbour;                    // F: cell id, or none on the boundary
    std::shared_ptr<const void> keep_alive{}; // owns the arrays and the loader; null in a view without an owner
    // Null if all positions are ready to be read. Otherwise extraction, slices, gradients, CellLocator, face_surface,
    // threshold_surface, vertices_of_cells, boundary_faces_at and size_of_faces load the positions that they use.
    // Before a call of any other function, the caller must call loader->load for all vertices.
    const VertexLoader* loader = nullptr;

    [[nodiscard]] Index vertex_count() const { return static_cast<Index>(positions.size() / 3); }
    [[nodiscard]] Index cell_count() const { return static_cast<Index>(cell_types.size()); }
    [[nodiscard]] Index face_count() const { return static_cast<Index>(owner.size()); }
    // Returns the vector that converts an offset from `origin` to an offset from `surface_origin` when it is added.
    [[nodiscard]] Vec3d surface_shift() const {
        return {origin[0] - surface_origin[0], origin[1] - surface_origin[1], origin[2] - surface_origin[2]};
    }
    // Returns this view. Throws Error when the view has no owner.
    [[nodiscard]] const FaceMeshView& owned() const {
        if (!keep_alive) fail("the mesh view has no owner, so it cannot be kept; use shared_view");
        return *this;
    }
    // Makes the positions of `vertices` ready to be read. Throws Error when a position cannot be read.
    void load(std::span<const Index> vertices) const {
        if (loader == nullptr) return;
        for (const Index vertex : vertices) loader->load(vertex, vertex + 1);
    }
    [[nodiscard]] Ids loop(Index face) const {
        const std::uint64_t begin = face_offset[face], end = face_offset[std::size_t{face} + 1];
        if (begin > end) [[unlikely]]
            face_offset.refuse();
        return face_vertex.part(begin, end - begin);
    }
};

// Returns a view of these arrays, without an owner, in which surface_origin is `origin`.
[[nodiscard]] inline FaceMeshView face_mesh_view(Vec3d origin, ValuesView positions,
                                                 std::span<const std::uint8_t> cell_types,
                                                 std::span<const std::uint64_t> face_offset,
                                                 std::span<const Index> face_vertex, std::span<const Index> owner,
                                                 std::span<const Index> neighbour) {
    const auto vertices = static_cast<Index>(positions.size() / 3), cells = static_cast<Index>(cell_types.size());
    return {origin,
            origin,
            positions,
            cell_types,
            {face_offset, face_vertex.size() + 1},
            {face_vertex, vertices},
            {owner, cells},
            {neighbour, cells},
            {},
            nullptr};
}

// Owns the arrays of a mesh. FaceMeshView describes the arrays.
struct FaceMesh {
    Vec3d origin{};
    std::vector<float> positions;
    std::vector<double> double_positions; // if not empty, used instead of `positions`
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> owner;
    std::vector<Index> neighbour;

    // Replace all positions.
    void set_positions(std::vector<float> all) {
        positions = std::move(all);
        double_positions.clear();
    }
    void set_positions(std::vector<double> all) {
        double_positions = std::move(all);
        positions.clear();
    }
    // Returns a view without an owner.
    [[nodiscard]] FaceMeshView view() const& {
        const ValuesView used = double_positions.empty() ? ValuesView(positions) : ValuesView(double_positions);
        return face_mesh_view(origin, used, cell_types, face_offset, face_vertex, owner, neighbour);
    }
    FaceMeshView view() && = delete; // use shared_view
};

// Returns a view that owns the arrays of `mesh`.
[[nodiscard]] inline FaceMeshView shared_view(FaceMesh mesh) {
    const auto kept = std::make_shared<const FaceMesh>(std::move(mesh));
    FaceMeshView view = kept->view();
    view.keep_alive = kept;
    return view;
}

} // namespace ciel
