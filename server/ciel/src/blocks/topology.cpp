#include "ciel/topology.hpp"

#include "blocks/block_linker.hpp"
#include "blocks/block_tables.hpp"
#include "blocks/blocks.hpp"
#include "blocks/check_records.hpp"
#include "blocks/records_in_memory.hpp"
#include "ciel/parallel.hpp"
#include "ciel/threads.hpp"
#include "mesh/standard_shapes.hpp"

#include <algorithm>
#include <atomic>
#include <iterator>
#include <string>
#include <utility>

namespace ciel {

using namespace detail;

namespace {

// A block gets fewer than `cells_per_block` cells if its local ids might not fit 16 bits (BlockBuilder::fits_16_bits).
// Only a block of one giant cell may exceed `room` and `corner_room`.
std::vector<Index> divide(const FaceMeshView& mesh, const CellFaces& faces, Index cells_per_block) {
    constexpr std::uint64_t room = 96000, corner_room = 64000;
    std::vector<Index> begin{0};
    std::uint64_t used = 0, corners = 0; // corners: each face counted once
    for (Index cell = 0; cell < mesh.cell_count(); ++cell) {
        std::uint64_t of_cell = 0, new_corners = 0;
        std::size_t largest = 0;
        for (const Index f : faces.of(cell)) {
            const std::size_t size = mesh.loop(f).size();
            of_cell += size;
            largest = std::max(largest, size);
            if (mesh.owner[f] == cell || mesh.owner[f] < begin.back()) new_corners += size;
        }
        const bool standard = type_of_faces(faces.of(cell).size(), of_cell, largest) != CellType::polyhedron;
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
             RecordsInMemory& records)
        : mesh_(mesh), faces_(faces), cell_begin_(cell_begin), linker_(linker), records_(records),
          built_(cell_begin.size() - 1) {}

    void run() {
        parallel_for(thread_count(), 1, [this](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin) build_until_none_is_left();
        });
    }

private:
    void build_until_none_is_left() {
        BlockBuilder builder(mesh_, faces_);
        for (std::size_t b = next_++; b < built_.size(); b = next_++) {
            auto built = std::make_unique<BuiltBlock>(builder.build(cell_begin_[b], cell_begin_[b + 1]));
            for (const BlockLinker::CompleteRecord& record : link(b, std::move(built)))
                records_.set(record.block, record.kind, record.make());
        }
    }
    [[nodiscard]] std::vector<BlockLinker::CompleteRecord> link(std::size_t b, std::unique_ptr<BuiltBlock> built) {
        const Locked lock(mutex_);
        built_[b] = std::move(built);
        std::vector<BlockLinker::CompleteRecord> complete;
        for (; linked_ < built_.size() && built_[linked_]; ++linked_)
            std::ranges::move(linker_.add(std::move(*std::exchange(built_[linked_], nullptr))),
                              std::back_inserter(complete));
        return complete;
    }

    const FaceMeshView& mesh_;
    const CellFaces& faces_;
    std::span<const Index> cell_begin_; // by block, and the number of cells
    BlockLinker& linker_;
    RecordsInMemory& records_;
    std::atomic<std::size_t> next_{0}; // block
    Mutex mutex_;
    std::vector<std::unique_ptr<BuiltBlock>> built_; // blocks that are not linked
    std::size_t linked_ = 0;
};

RecordBytes copy_of(std::span<const std::byte> record) {
    RecordBytes copied((record.size() + sizeof(RecordBytes::value_type) - 1) / sizeof(RecordBytes::value_type));
    std::ranges::copy(record, std::as_writable_bytes(std::span(copied)).begin());
    return copied;
}

template <class... Vectors>
std::size_t bytes(const Vectors&... vectors) {
    return (std::size_t{0} + ... + (vectors.capacity() * sizeof(vectors[0])));
}

} // namespace

Topology::Topology(const FaceMeshView& mesh, Options options) : blocks_(std::make_shared<Blocks>()) {
    check_face_mesh(mesh);
    const CellFaces faces = cell_faces(mesh);
    const std::vector<Index> begin = divide(mesh, faces, std::max<Index>(1, options.cells_per_block));
    const std::vector<Index> last_cell = last_cells(mesh);
    auto records = std::make_unique<RecordsInMemory>(begin.size() - 1);
    BlockLinker linker(last_cell);
    Building(mesh, faces, begin, linker, *records).run();
    linker.finish();
    blocks_->numbers = std::move(linker.numbers());
    blocks_->source = std::move(records);
    blocks_->counts = {mesh.vertex_count(),
                       linker.edge_count(),
                       mesh.face_count(),
                       linker.half_edge_count(),
                       static_cast<std::uint64_t>(std::ranges::count(mesh.neighbour.unchecked(), none)),
                       mesh.cell_count(),
                       count_components(mesh)};
    blocks_->begin();
}

Topology::Topology(std::span<const std::byte> tables, std::unique_ptr<RecordSource> source)
    : blocks_(std::make_shared<Blocks>()) {
    read_tables(tables, blocks_->numbers, blocks_->counts);
    blocks_->source = std::move(source);
    blocks_->begin();
}

std::vector<std::uint64_t> Topology::tables() const { return tables_of(blocks_->numbers, blocks_->counts); }

std::span<const std::byte> Topology::record(Index block, RecordKind kind) const {
    return blocks_->source->record(block, kind);
}

const TopologyCounts& Topology::counts() const { return blocks_->counts; }
Index Topology::block_count() const { return blocks_->count(); }

std::size_t Topology::memory_bytes() const { return blocks_->memory_bytes(); }

void Topology::Blocks::begin() {
    cells_.resize(count());
    around_.resize(count());
    mates_.resize(count());
    is_trusted_ = source->is_trusted();
}

// The blocks of a ring ascend, except at one step. Therefore a walk whose steps do not pass the block `start` ends.
void Topology::Blocks::check_ring(BorderVertex at, BorderVertex next, Index start) const {
    const bool onwards =
        at.block < start ? next.block > at.block && next.block <= start : next.block > at.block || next.block <= start;
    if (!onwards || cells(at.block).vertex(vertex_at(at)) != cells(next.block).vertex(vertex_at(next)))
        fail("the blocks " + std::to_string(at.block) + " and " + std::to_string(next.block) +
             " of the mesh contradict each other about a vertex that they share; import the dataset again");
}

// A changed 32-bit id may lead to any address. Therefore records with such ids are copied, and the copies checked.
Block Topology::Blocks::read_cells(Index b) const {
    const std::span<const std::byte> record = source->record(b, RecordKind::cells);
    Block block = view_cells(record, b, numbers);
    if (is_trusted_) return block;
    if (std::holds_alternative<PolyhedralSection<std::uint32_t>>(block.polyhedra)) {
        RecordBytes copied = copy_of(record);
        block = view_cells(std::as_bytes(std::span(copied)), b, numbers);
        block.copied = std::move(copied);
    }
    check_cells(block, b, numbers);
    return block;
}

BlockAround Topology::Blocks::read_around(Index b) const {
    const Block& block = cells(b);
    std::span<const std::byte> record = source->record(b, RecordKind::around);
    RecordBytes copied;
    if (!block.copied.empty()) record = std::as_bytes(std::span(copied = copy_of(record)));
    BlockAround around = view_around(record, b, numbers, block);
    around.copied = std::move(copied);
    if (!is_trusted_) check_around(block, around, b, numbers);
    return around;
}

BlockMates Topology::Blocks::read_mates(Index b) const {
    const Block& block = cells(b);
    std::span<const std::byte> record = source->record(b, RecordKind::mates);
    RecordBytes copied;
    if (!block.copied.empty()) record = std::as_bytes(std::span(copied = copy_of(record)));
    BlockMates mates = view_mates(record, b, numbers, block);
    mates.copied = std::move(copied);
    if (!is_trusted_) check_mates(block, mates, b, numbers);
    return mates;
}

std::size_t Topology::Blocks::memory_bytes() const {
    std::size_t sum =
        sizeof(Blocks) +
        bytes(numbers.cell, numbers.vertex, numbers.edge, numbers.slot, numbers.half_edges, numbers.border_vertices) +
        3 * sizeof(void*) * numbers.block_count() + source->memory_bytes();
    cells_.for_each([&](const Block& block) {
        sum += sizeof(Block) + bytes(block.ghost_vertex.begin, block.ghost_edge.begin, block.standard, block.copied);
    });
    around_.for_each([&](const BlockAround& around) {
        sum += sizeof(BlockAround) + bytes(around.neighbour, around.next_entry, around.copied);
    });
    mates_.for_each(
        [&](const BlockMates& mates) { sum += sizeof(BlockMates) + bytes(mates.neighbour, mates.mate, mates.copied); });
    return sum;
}

Index Topology::Blocks::block_of_cell(Index cell) const {
    return static_cast<Index>(std::ranges::upper_bound(numbers.cell, cell) - numbers.cell.begin() - 1);
}

} // namespace ciel
