// FaceMesh: a mesh as a list of faces, each with an owner and a neighbour cell. An import makes this form, and Topology
// is built from it. It is the input of Algorithm 5 (paper, appendix A) after the faces have been matched.
#pragma once

#include "ciel/checked_array.hpp"
#include "ciel/value_source.hpp"
#include "ciel/values_view.hpp"

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace ciel {

// View of a FaceMesh; the arrays must outlive every use, unless keep_alive owns them. V vertices, F faces, C cells.
// Indices are checked at each read, because the arrays may be in a mapped file. Positions and types are not checked:
// any value is harmless. A face between two cells is stored once. Its loop is wound so that its normal (right hand)
// points out of `owner` into `neighbour`. owner < neighbour; neighbour is `none` on the boundary. Repeated vertex ids
// in a loop (collapsed cells) are allowed and kept. Cells are in storage order, which is a space-filling-curve order.
// Faces are sorted by owner; vertices by first use, unused last. The lists of numbered_faces.hpp may have other orders.
struct FaceMeshView {
    using Offsets = CheckedArray<std::uint64_t>;

    Vec3d origin{};                           // added to every position
    Vec3d surface_origin{};                   // positions of surfaces are floats relative to it; any place near them
    ValuesView positions;                     // 3 V: offsets from origin
    std::span<const std::uint8_t> cell_types; // C: CellType
    Offsets face_offset;                      // F + 1: index in face_vertex of the first vertex of each face
    Ids face_vertex;                          // vertex ids, loop by loop
    Ids owner;                                // F: cell id
    OptionalIds neighbour;                    // F: cell id, or none on the boundary
    std::shared_ptr<const void> keep_alive{}; // owns the positions and the loader; null if the caller keeps them
    // Null if all positions can be read. If not, extraction, slices, gradients, CellLocator, face_surface,
    // threshold_surface, vertices_of_cells, boundary_faces_at, size_of_faces and slab_boundary load the positions that
    // they use. Before any other function, the caller must call loader->load for all vertices.
    const VertexLoader* loader = nullptr;

    [[nodiscard]] Index vertex_count() const { return static_cast<Index>(positions.size() / 3); }
    [[nodiscard]] Index cell_count() const { return static_cast<Index>(cell_types.size()); }
    [[nodiscard]] Index face_count() const { return static_cast<Index>(owner.size()); }
    // Returns what is added to a stored position to make it relative to surface_origin.
    [[nodiscard]] Vec3d surface_shift() const {
        return {origin[0] - surface_origin[0], origin[1] - surface_origin[1], origin[2] - surface_origin[2]};
    }
    // Makes the positions of these vertices ready to be read. Throws Error when they cannot be read.
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

// Returns a view of these arrays. Positions of surfaces are relative to `origin`, too: surface_origin is `origin`.
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

struct FaceMesh {
    Vec3d origin{};
    std::vector<float> positions;
    std::vector<double> double_positions; // used instead of `positions` unless empty
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> owner;
    std::vector<Index> neighbour;

    // Both replace all positions.
    void set_positions(std::vector<float> all) {
        positions = std::move(all);
        double_positions.clear();
    }
    void set_positions(std::vector<double> all) {
        double_positions = std::move(all);
        positions.clear();
    }
    [[nodiscard]] FaceMeshView view() const {
        const ValuesView used = double_positions.empty() ? ValuesView(positions) : ValuesView(double_positions);
        return face_mesh_view(origin, used, cell_types, face_offset, face_vertex, owner, neighbour);
    }
};

} // namespace ciel
