// Topology: the paper's data structure (section 2.2). Half-edges in blocks of consecutive cells, with all six
// operators.
#pragma once

#include "ciel/face_mesh.hpp"
#include "ciel/record_source.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace ciel {

// A half-edge of one Topology. Opaque: can be kept, compared, hashed, and given to the operators of its Topology.
enum class HalfEdge : std::uint64_t {};
inline constexpr HalfEdge no_half_edge{~std::uint64_t{0}};

// Numbers of elements. `half_edges` counts both sides of a face between two cells. `components` are sets of cells
// connected by faces.
struct TopologyCounts {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, cells = 0, components = 0;
};

// Immutable once built, and thread-safe, so any number of Queries may share it. Keeps no reference to the FaceMeshView,
// whose arrays may be freed after the build.
class Topology {
public:
    struct Options {
        Index cells_per_block = 4096; // a block gets fewer cells if its local ids would exceed 16 bits
    };
    // Throws Error when the mesh breaks the contract of FaceMeshView.
    explicit Topology(const FaceMeshView& mesh, Options options);
    explicit Topology(const FaceMeshView& mesh) : Topology(mesh, Options{}) {}
    // A topology that was built elsewhere: `tables` is what tables() returned there, `source` gives its records. Reads
    // no record. Throws Error when the tables are damaged. The operators, and all that uses a block, then throw Error
    // when a record is damaged.
    Topology(std::span<const std::byte> tables, std::unique_ptr<RecordSource> source);
    ~Topology();
    Topology(Topology&&) noexcept;
    Topology& operator=(Topology&&) noexcept;

    // The six operators. Vertex and cell ids are those of the FaceMeshView that the topology was built from. For the
    // topology of a Mesh these are the stored ids (Mesh::stored), not the caller's; Mesh::original_vertex and
    // Mesh::original_cell lead from the one to the other. `vertex` is the vertex that the half-edge points to, as in
    // the paper; `edge` is a mesh-wide edge id. mate_polyhedron is no_half_edge on a boundary face. next_around_vertex
    // runs through all half-edges that leave the half-edge's origin (the paper's appendix A), across blocks. Repeated
    // vertices of a loop (collapsed cells) make no half-edge. So every half-edge joins two distinct vertices, and
    // mate_face(h) is never h. If a face has collapsed to a line, mate_face may return a half-edge of the same face.
    // Edge ids follow the first appearance of the edge in the mesh's faces, so they do not depend on the blocks.
    [[nodiscard]] Index vertex(HalfEdge h) const;
    [[nodiscard]] Index edge(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_vertex(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_polyhedron(HalfEdge h) const;

    [[nodiscard]] Index cell(HalfEdge h) const;
    [[nodiscard]] HalfEdge half_edge_of_vertex(Index vertex) const;   // one that leaves the vertex, or no_half_edge
    [[nodiscard]] HalfEdge half_edge_begin(Index cell) const;         // first of half_edges(cell), or no_half_edge
    [[nodiscard]] std::vector<HalfEdge> half_edges(Index cell) const; // allocates memory: not for hot loops

    [[nodiscard]] const TopologyCounts& counts() const;
    [[nodiscard]] Index block_count() const;
    // Returns the size of all tables of the topology, without positions and fields.
    [[nodiscard]] std::size_t memory_bytes() const;

    // Return the bytes from which a Topology like this can be made: the tables of all blocks, and a record of a block,
    // which lives as long as this Topology. Little-endian; formats: src/blocks/record.hpp.
    [[nodiscard]] std::vector<std::uint64_t> tables() const;
    [[nodiscard]] std::span<const std::byte> record(Index block, RecordKind kind) const;

    struct Blocks; // defined in src/blocks/blocks.hpp, for the kernel only
    [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

private:
    std::unique_ptr<Blocks> blocks_;
};

} // namespace ciel
