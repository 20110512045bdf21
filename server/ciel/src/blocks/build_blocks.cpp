#include "blocks/build_blocks.hpp"

#include "blocks/block_linker.hpp"
#include "blocks/block_tables.hpp"
#include "ciel/parallel.hpp"
#include "ciel/threads.hpp"
#include "mesh/standard_shapes.hpp"

#include <algorithm>
#include <atomic>
#include <map>
#include <utility>

namespace ciel {

namespace detail {

namespace {

// A block gets fewer than `cells_per_block` cells if its local ids might not fit 16 bits (BlockBuilder::fits_16_bits).
// Only a block of one giant cell may exceed `room` and `corner_room`.
std::vector<Index> divide(const FaceMeshView& mesh, const CellFaces& faces, Index cells_per_block) {
    constexpr std::uint64_t room = 96000, corner_room = 64000;
    std::vector<Index> begin{0};
    std::uint64_t used = 0, corners = 0; // corners: each face counted once
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::uint64_t of_cell = 0, new_corners = 0;
        std::size_t count = 0, largest = 0;
        faces.for_faces(cell, [&, first = faces.own_begin[begin.back()], own = faces.own_begin[cell]](Index face) {
            const std::size_t size = mesh.loop(face).size();
            of_cell += size;
            largest = std::max(largest, size);
            ++count;
            if (face < first || face >= own) new_corners += size;
        });
        const bool standard = type_of_faces(count, of_cell, largest) != CellType::polyhedron;
        const std::uint64_t room_of_cell = standard ? 2 * of_cell : of_cell;
        used += room_of_cell;
        corners += new_corners;
        if (cell > begin.back() && (cell - begin.back() == cells_per_block || used > room || corners > corner_room)) {
            begin.push_back(cell);
            used = room_of_cell;
            corners = of_cell;
        }
    }
    if (mesh.cell_count() > 0) begin.push_back(mesh.cell_count());
    return begin;
}

std::uint64_t count_components(const FaceMeshView& mesh) {
    std::vector<Index> parent(mesh.cell_count());
    for (Index c = 0; c < parent.size(); ++c) parent[c] = c;
    const auto root = [&](Index c) {
        while (parent[c] != c) c = parent[c] = parent[parent[c]];
        return c;
    };
    std::uint64_t components = parent.size();
    const Ids owners = mesh.owner; // local copies, so that their index limits stay in registers
    const OptionalIds neighbours = mesh.neighbour;
    for (std::size_t f = 0; f < owners.size(); ++f) {
        const Index neighbour = neighbours[f];
        if (neighbour == none) continue;
        const Index a = root(owners[f]), b = root(neighbour);
        if (a == b) continue;
        parent[std::max(a, b)] = std::min(a, b);
        --components;
    }
    return components;
}

// Returns the last cell with a face that has the vertex, for each vertex.
std::vector<Index> last_cells(const FaceMeshView& mesh) {
    std::vector<Index> last(mesh.vertex_count(), 0);
    const auto owners = mesh.owner.unchecked(), neighbours = mesh.neighbour.unchecked();
    const auto offsets = mesh.face_offset.unchecked();
    const auto vertices = mesh.face_vertex.unchecked();
    std::uint64_t at = 0;
    for (std::size_t face = 0; face < owners.size(); ++face) {
        const Index neighbour = neighbours[face], cell = neighbour == none ? owners[face] : neighbour;
        for (const std::uint64_t end = std::min<std::uint64_t>(offsets[face + 1], vertices.size()); at < end; ++at) {
            const Index vertex = vertices[at];
            if (vertex >= last.size()) mesh.face_vertex.refuse(); // the mapped file changed
            if (last[vertex] < cell) last[vertex] = cell;
        }
    }
    return last;
}

// Builds the blocks in parallel, and links each one when all earlier ones are linked.
class Building {
public:
    Building(const FaceMeshView& mesh, const CellFaces& faces, std::span<const Index> cell_begin, BlockLinker& linker,
             RecordSink& sink)
        : mesh_(mesh), faces_(faces), cell_begin_(cell_begin), linker_(linker), sink_(sink),
          built_(cell_begin.size() - 1) {}

    void run() {
        parallel_for(thread_count(), 1, [this](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin) build_until_none_is_left();
        });
    }

private:
    struct Linked {
        std::size_t place; // among all records, in the order of the calls of the sink
        BlockLinker::CompleteRecord record;
    };
    struct Made {
        Index block;
        RecordKind kind;
        RecordBytes bytes;
    };

    void build_until_none_is_left() {
        BlockBuilder builder(mesh_, faces_);
        for (std::size_t b = next_++; b < built_.size(); b = next_++) {
            auto built = std::make_unique<BuiltBlock>(builder.build(cell_begin_[b], cell_begin_[b + 1]));
            for (const Linked& linked : link(b, std::move(built)))
                put(linked.place, {linked.record.block, linked.record.kind, linked.record.make()});
        }
    }
    [[nodiscard]] std::vector<Linked> link(std::size_t b, std::unique_ptr<BuiltBlock> built) {
        const Locked lock(linking_);
        built_[b] = std::move(built);
        std::vector<Linked> complete;
        for (; linked_ < built_.size() && built_[linked_]; ++linked_)
            for (BlockLinker::CompleteRecord& record : linker_.add(std::move(*std::exchange(built_[linked_], nullptr))))
                complete.push_back({places_++, std::move(record)});
        return complete;
    }
    // A record that the sink refuses leaves `made_` without a call, so that no call follows.
    void put(std::size_t place, Made made) {
        const Locked lock(putting_);
        made_.emplace(place, std::move(made));
        while (!made_.empty() && made_.begin()->first == put_) {
            Made next = std::move(made_.extract(made_.begin()).mapped());
            sink_.put(next.block, next.kind, std::move(next.bytes));
            ++put_;
        }
    }

    const FaceMeshView& mesh_;
    const CellFaces& faces_;
    std::span<const Index> cell_begin_; // by block, and the number of cells
    BlockLinker& linker_;
    RecordSink& sink_;
    std::atomic<std::size_t> next_{0}; // block
    Mutex linking_;
    std::vector<std::unique_ptr<BuiltBlock>> built_; // blocks that are not linked
    std::size_t linked_ = 0, places_ = 0;
    Mutex putting_;
    std::map<std::size_t, Made> made_; // by place: records that wait for an earlier one
    std::size_t put_ = 0;
};

} // namespace

BuiltBlocks build_blocks(const FaceMeshView& mesh, Topology::Options options, RecordSink& sink) {
    check_face_mesh(mesh);
    const CellFaces faces = cell_faces(mesh);
    const std::vector<Index> begin = divide(mesh, faces, std::max<Index>(1, options.cells_per_block));
    const std::vector<Index> last_cell = last_cells(mesh);
    BlockLinker linker(last_cell);
    Building(mesh, faces, begin, linker, sink).run();
    linker.finish();
    return {std::move(linker.numbers()),
            {mesh.vertex_count(), linker.edge_count(), mesh.face_count(), linker.half_edge_count(),
             static_cast<std::uint64_t>(std::ranges::count(mesh.neighbour.unchecked(), none)), mesh.cell_count(),
             count_components(mesh)}};
}

} // namespace detail

BuiltRecords build_records(const FaceMeshView& mesh, RecordSink& sink, Topology::Options options) {
    const detail::BuiltBlocks built = detail::build_blocks(mesh, options, sink);
    return {detail::tables_of(built.numbers, built.counts), built.counts};
}

} // namespace ciel
