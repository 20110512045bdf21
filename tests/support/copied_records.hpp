// A topology's records as they would come from a file, and functions that read all kinds of them.
#pragma once

#include "ciel/cell_locator.hpp"
#include "ciel/extract.hpp"
#include "ciel/mesh_faces.hpp"
#include "support/boundary.hpp"
#include "support/kept.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <map>
#include <memory>
#include <string_view>
#include <vector>

namespace ciel::test {

class CopiedRecords final : public RecordSource {
public:
    using Bytes = std::vector<std::uint64_t>;

    explicit CopiedRecords(const Topology& topology);
    std::span<const std::byte> record(Index block, RecordKind kind) override;
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

    Bytes tables;
    std::map<std::pair<Index, RecordKind>, Bytes> records;
    std::atomic<int> reads = 0;
};

inline CopiedRecords::CopiedRecords(const Topology& topology) : tables(topology.tables()) {
    for (Index b = 0; b < topology.block_count(); ++b)
        for (const RecordKind kind : {RecordKind::cells, RecordKind::around, RecordKind::mates}) {
            const auto bytes = topology.record(b, kind);
            Bytes& copy = records[{b, kind}];
            copy.resize(bytes.size() / sizeof(copy[0]));
            std::memcpy(copy.data(), bytes.data(), bytes.size());
        }
}

inline std::span<const std::byte> CopiedRecords::record(Index block, RecordKind kind) {
    ++reads;
    return std::as_bytes(std::span(records.at({block, kind})));
}

// Returns the topology that the records describe. It owns the records.
[[nodiscard]] inline Topology read_back(std::unique_ptr<CopiedRecords> copied) {
    const CopiedRecords::Bytes tables = copied->tables;
    return {std::as_bytes(std::span(tables)), std::move(copied)};
}

// Returns the results of the six operators for all half-edges.
[[nodiscard]] inline std::vector<std::uint64_t> all_operators(const Topology& topology) {
    std::vector<std::uint64_t> found;
    const auto add = [&found](auto... ids) { (found.push_back(static_cast<std::uint64_t>(ids)), ...); };
    for (Index cell = 0; cell < topology.counts().cells; ++cell)
        for (const HalfEdge h : topology.half_edges(cell))
            add(h, topology.vertex(h), topology.edge(h), topology.next_around_face(h), topology.next_around_vertex(h),
                topology.mate_face(h), topology.mate_polyhedron(h), topology.cell(h));
    return found;
}

// Calls the point location of a topology at some vertices, so that the records it needs are read.
inline void probe_some(const Topology& topology, const FaceMeshView& mesh) {
    const CellLocator locator(topology, mesh,
                              std::make_shared<const BlockBoxes>(block_boxes(topology, mesh.positions)));
    for (std::size_t vertex = 0; vertex < mesh.vertex_count(); vertex += 1 + mesh.vertex_count() / 8) {
        Vec3d place = mesh.origin;
        for (std::size_t axis = 0; axis < 3; ++axis) place[axis] += mesh.positions[3 * vertex + axis];
        const Index cell = locator.cell_at(place);
        if (cell == none) continue;
        (void)locator.nearest_vertex(cell, place);
        (void)locator.weights_in(cell, place);
    }
}

// Computes the surface and the vertices of the cells in a range, and all faces, so that the records they need are read.
inline void threshold_some(const Topology& topology, const FaceMeshView& mesh, std::span<const float> values) {
    const Boundary boundary(mesh);
    const BlockBoxes boxes = block_boxes(topology, mesh.positions);
    const Field field(topology, values, kept_by_test);
    for (const InRange vertices : {InRange::all, InRange::any}) {
        const auto kept = cells_in_range(field, {0.3, 0.8}, vertices);
        (void)threshold_surface(topology, boundary.faces(), boxes, kept);
        (void)vertices_of_cells(topology, mesh, kept);
    }
    (void)all_faces(topology, boundary.faces());
}

// With each algorithm, extracts one surface of every second block and three of all blocks, with gradient normals.
// Returns the last surface.
[[nodiscard]] inline Surface cut_in_all_ways(const Topology& topology, const FaceMeshView& mesh,
                                             std::span<const float> values) {
    Field field(topology, values, kept_by_test);
    field.set_cell_fits(std::make_shared<CellFits>(topology));
    std::vector<Index> second;
    for (Index b = 1; b < topology.block_count(); b += 2) second.push_back(b);
    Surface surface;
    for (const Algorithm algorithm : {Algorithm::naive, Algorithm::signatures, Algorithm::propagation}) {
        Query query(topology, mesh, algorithm);
        query.set_field(field);
        query.set_blocks(second);
        query.extract(0.5, true, surface);
        query.set_blocks(std::nullopt);
        for (const double nu : {0.3, 0.6, 0.45}) query.extract(nu, true, surface);
    }
    return surface;
}

// Returns whether an error about records ends with one of the three known pieces of advice.
[[nodiscard]] inline bool says_what_to_do(std::string_view sentence) {
    constexpr std::array<std::string_view, 3> advice{"; import the dataset again", ". Update CIEL",
                                                     "; split the dataset"};
    return std::any_of(advice.begin(), advice.end(), [&](std::string_view end) { return sentence.ends_with(end); });
}

} // namespace ciel::test
