// The CIEL structure (paper, section 2.2): half-edges in blocks of consecutive cells, with all six operators.
#pragma once

#include "ciel/face_mesh.hpp"

#include <cstddef>
#include <memory>

namespace ciel {

using HalfEdge = std::uint32_t; // a block's prefix + the index inside the block

// Half-edges count both sides of a face between two cells. Components hang together by faces.
struct TopologyCounts {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, cells = 0, components = 0;
};

// Immutable once built; shared by all sessions and safe to read from any thread. Keeps a reference to nothing: the
// FaceMeshView may go away after the build.
class Topology {
public:
    struct Options {
        Index cells_per_block = 4096; // fewer where their half-edges would not fit 16 bits
    };
    // Throws Error when the mesh breaks the contract of FaceMeshView.
    explicit Topology(const FaceMeshView& mesh, Options options);
    explicit Topology(const FaceMeshView& mesh) : Topology(mesh, Options{}) {}
    ~Topology();
    Topology(Topology&&) noexcept;
    Topology& operator=(Topology&&) noexcept;

    // A loop's repeated vertices (collapsed cells) make no half-edge: every half-edge joins two distinct vertices, and
    // mate_face never leads back to itself. Edge ids follow the first appearance of the edge in the mesh's faces, so
    // they do not depend on the blocks; a face that collapsed to a line is its own neighbour at worst. The six
    // operators. `vertex` is the vertex the half-edge points to, as in the paper; `edge` a mesh-wide edge id.
    // mate_polyhedron is `none` on a boundary face. next_around_vertex runs through all half-edges that leave the
    // half-edge's origin (the paper's appendix A), across blocks.
    [[nodiscard]] Index vertex(HalfEdge h) const;
    [[nodiscard]] Index edge(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_vertex(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_polyhedron(HalfEdge h) const;

    [[nodiscard]] Index cell(HalfEdge h) const;
    [[nodiscard]] HalfEdge half_edge_of_vertex(Index vertex) const;   // one that leaves it, or none
    [[nodiscard]] HalfEdge half_edge_begin(Index cell) const;         // a cell's half-edges are not contiguous ids:
    [[nodiscard]] std::vector<HalfEdge> half_edges(Index cell) const; // use this (tests, probes), not in hot loops

    [[nodiscard]] const TopologyCounts& counts() const;
    [[nodiscard]] Index block_count() const;
    // All six operators, duplicates, escapes and block tables; not positions, not fields.
    [[nodiscard]] std::size_t memory_bytes() const;

    struct Blocks; // the layout, for the kernel's own files (blocks.hpp)
    [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

private:
    std::unique_ptr<Blocks> blocks_;
};

} // namespace ciel
