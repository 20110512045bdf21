// A mesh as faces with an owner and a neighbour: what the store keeps and what the CIEL topology is built from. It is
// the input of Algorithm 5 (paper, appendix A) with its faces matched.
#pragma once

#include "ciel/types.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace ciel {

// Borrowed; the owner of the arrays must outlive every use. V vertices, F faces, C cells.
// A face between two cells is stored once. Its loop is wound so that its normal (right hand) points out of `owner`
// into `neighbour`; owner < neighbour; neighbour is `none` on the boundary. Repeated vertex ids in a loop (collapsed
// cells) are allowed and kept. Cells are in storage order, which is a space-filling-curve order; faces are sorted by
// owner, vertices by their first use in face_vertex; those that no face uses come last.
struct FaceMeshView {
    Vec3d origin{};                             // added to every position
    std::span<const float> positions;           // 3 V: offsets from origin
    std::span<const std::uint8_t> cell_types;   // C: CellType
    std::span<const std::uint64_t> face_offset; // F + 1, into face_vertex
    std::span<const Index> face_vertex;         // vertex ids of each loop
    std::span<const Index> owner;               // F
    std::span<const Index> neighbour;           // F

    [[nodiscard]] Index vertex_count() const { return static_cast<Index>(positions.size() / 3); }
    [[nodiscard]] Index cell_count() const { return static_cast<Index>(cell_types.size()); }
    [[nodiscard]] Index face_count() const { return static_cast<Index>(owner.size()); }
    [[nodiscard]] std::span<const Index> loop(Index face) const {
        return face_vertex.subspan(face_offset[face], face_offset[face + 1] - face_offset[face]);
    }
};

struct FaceMesh {
    Vec3d origin{};
    std::vector<float> positions;
    std::vector<std::uint8_t> cell_types;
    std::vector<std::uint64_t> face_offset{0};
    std::vector<Index> face_vertex;
    std::vector<Index> owner;
    std::vector<Index> neighbour;

    [[nodiscard]] FaceMeshView view() const {
        return {origin, positions, cell_types, face_offset, face_vertex, owner, neighbour};
    }
};

} // namespace ciel
