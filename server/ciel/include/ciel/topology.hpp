// Topology: the paper's data structure (section 2.2). It stores half-edges in blocks of consecutive cells, and has the
// paper's six operators.
#pragma once

#include "ciel/face_mesh.hpp"
#include "ciel/record_source.hpp"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace ciel {

// A half-edge of one Topology. The number has no public meaning. A half-edge can be kept, compared, hashed, and passed
// to the operators of the same Topology.
enum class HalfEdge : std::uint64_t {};
inline constexpr HalfEdge no_half_edge{~std::uint64_t{0}};

// Numbers of elements of a mesh. half_edges: a face between two cells has half-edges on both sides; all of them are
// counted. components: number of sets of cells that are connected by faces.
struct TopologyCounts {
    std::uint64_t vertices = 0, edges = 0, faces = 0, half_edges = 0, boundary_faces = 0, cells = 0, components = 0;
};

// A value: copies share their tables, so that a copy is cheap. Fields, Queries, CellFits and CellLocators keep a copy.
// Immutable after construction and thread-safe. A topology keeps no reference to the FaceMeshView from which it was
// built; the arrays may be freed after the construction.
class Topology {
public:
    struct Options {
        Index cells_per_block = 4096; // a block has fewer cells if its local ids might not fit 16 bits
    };
    // Builds the topology, on all threads of parallel_for. Throws Error when `mesh` breaks the contract of
    // FaceMeshView.
    explicit Topology(const FaceMeshView& mesh, Options options);
    explicit Topology(const FaceMeshView& mesh) : Topology(mesh, Options{}) {}
    // Makes a topology that was built earlier, for example before it was written to a file. `tables`: the bytes that
    // tables() of the built topology returned. `source`: provides the records of the blocks. Reads no record. Throws
    // Error when the tables are damaged. If a record is damaged, the operators and all functions that read the record's
    // block throw Error.
    Topology(std::span<const std::byte> tables, std::unique_ptr<RecordSource> source);

    // The six operators. Vertex and cell ids are those of the FaceMeshView from which the topology was built. In the
    // topology of a Mesh these are the stored ids (Mesh::stored); Mesh::original_vertex and Mesh::original_cell convert
    // them to the caller's ids.
    // vertex: the vertex that the half-edge points to, as in the paper.
    // edge: the mesh-wide id of the edge. Edge ids are in the order in which the edges first appear in the mesh's
    // faces, so that they do not depend on the blocks.
    // next_around_vertex: repeated calls visit all half-edges that leave the vertex from which `h` leaves (paper,
    // appendix A), in all blocks.
    // mate_polyhedron: no_half_edge on a boundary face.
    // The operators and cell() throw Error when the half-edge does not exist in this topology, and when a record cannot
    // be read or is damaged.
    // Repeated vertices of a loop (collapsed cells) make no half-edge. Therefore every half-edge joins two distinct
    // vertices, and mate_face(h) is never h. If a face has collapsed to a line, mate_face may return a half-edge of the
    // same face.
    [[nodiscard]] Index vertex(HalfEdge h) const;
    [[nodiscard]] Index edge(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge next_around_vertex(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_face(HalfEdge h) const;
    [[nodiscard]] HalfEdge mate_polyhedron(HalfEdge h) const;

    // REQUIRES: cells and vertices exist, that is, are below counts().cells and counts().vertices.
    [[nodiscard]] Index cell(HalfEdge h) const;
    [[nodiscard]] HalfEdge half_edge_of_vertex(Index vertex) const;   // one that leaves the vertex, or no_half_edge
    [[nodiscard]] HalfEdge half_edge_begin(Index cell) const;         // first of half_edges(cell), or no_half_edge
    [[nodiscard]] std::vector<HalfEdge> half_edges(Index cell) const; // allocates memory: slow in inner loops

    [[nodiscard]] const TopologyCounts& counts() const;
    [[nodiscard]] Index block_count() const;
    // Returns the size in bytes of all tables of the topology, without positions and fields.
    [[nodiscard]] std::size_t memory_bytes() const;

    // Return the bytes from which the same Topology can be made: the tables of all blocks, and one record of one block.
    // A record is valid while a copy of this Topology lives. Numbers are little-endian. Another version of the kernel
    // may have another format. Therefore pass the bytes only to a Topology of the same version, and do not interpret
    // them. Throws Error when the record cannot be read. REQUIRES: block < block_count().
    [[nodiscard]] std::vector<std::uint64_t> tables() const;
    [[nodiscard]] std::span<const std::byte> record(Index block, RecordKind kind) const;

    struct Blocks; // defined in src/blocks/blocks.hpp, for the kernel only
    [[nodiscard]] const Blocks& blocks() const { return *blocks_; }

private:
    std::shared_ptr<Blocks> blocks_; // shared by all copies
};

} // namespace ciel
