// A mesh as plain polyhedra: vertices, cells as lists of faces, faces as lists of vertex ids. Independent of the
// kernel.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace ciel::test {

using Id = std::uint32_t;
using Loop = std::vector<Id>;
using Point = std::array<double, 3>;

// VTK's cell type numbers.
inline constexpr std::uint8_t tetrahedron = 10, hexahedron = 12, wedge = 13, pyramid = 14, polyhedron = 42;

// A face between two cells occurs twice, once for each cell. The generators wind every face outwards.
struct Polyhedra {
    Point origin{};                            // added to every position
    std::vector<float> positions;              // x, y, z of each vertex
    std::vector<std::uint8_t> cell_types;      // VTK type of each cell
    std::vector<std::uint64_t> cell_offset{0}; // cells + 1 offsets into faces
    std::vector<std::uint64_t> face_offset{0}; // faces + 1 offsets into face_vertex
    std::vector<Id> face_vertex;

    [[nodiscard]] Id vertex_count() const { return static_cast<Id>(positions.size() / 3); }
    [[nodiscard]] Id cell_count() const { return static_cast<Id>(cell_types.size()); }
    [[nodiscard]] std::uint64_t face_count() const { return face_offset.size() - 1; }
    [[nodiscard]] std::span<const Id> face(std::uint64_t f) const {
        return std::span(face_vertex).subspan(face_offset[f], face_offset[f + 1] - face_offset[f]);
    }
    [[nodiscard]] Point position(Id v) const {
        return {origin[0] + positions[3 * v], origin[1] + positions[3 * v + 1], origin[2] + positions[3 * v + 2]};
    }

    Id add_vertex(const Point& offset);
    void add_cell(std::uint8_t type, const std::vector<Loop>& loops);
    [[nodiscard]] std::vector<Loop> loops(Id cell) const;
};

// Rotates the loop to start at its least vertex, keeping its direction.
[[nodiscard]] Loop canonical(Loop loop);

// Removes consecutive duplicate vertices, cyclically.
[[nodiscard]] Loop without_repeats(Loop loop);

// Positive when the faces are wound outwards. A nonplanar face counts as a fan from its first corner.
[[nodiscard]] double signed_volume(const Polyhedra& mesh, Id cell);

[[nodiscard]] Polyhedra keep_cells(const Polyhedra& mesh, const std::function<bool(Id cell)>& keep);

// Both meshes as one, without shared vertices. `second` is moved by `shift`.
[[nodiscard]] Polyhedra joined(const Polyhedra& first, const Polyhedra& second, const Point& shift);

// Merges random neighboring cells into nonconvex polyhedra of up to `size` cells, each a closed manifold.
[[nodiscard]] Polyhedra agglomerated(const Polyhedra& mesh, int size, std::uint64_t seed);

// The same mesh with its cells, each cell's faces and the first corner of each loop in random order. `cell_of[i]` is
// the cell of the input that became cell i.
struct Shuffled {
    Polyhedra mesh;
    std::vector<Id> cell_of;
};
[[nodiscard]] Shuffled shuffled(const Polyhedra& mesh, std::uint64_t seed);

// Reverses the winding of each face, or of all faces of each cell, with probability `share`.
[[nodiscard]] Polyhedra with_turned_faces(const Polyhedra& mesh, double share, std::uint64_t seed);
[[nodiscard]] Polyhedra with_turned_cells(const Polyhedra& mesh, double share, std::uint64_t seed);

} // namespace ciel::test
