#include "ciel/topology.hpp"

#include "blocks/block_building.hpp"
#include "blocks/block_tables.hpp"
#include "blocks/blocks.hpp"
#include "blocks/check_records.hpp"
#include "blocks/records_in_memory.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace ciel {

using namespace detail;

namespace {

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
    auto records = std::make_unique<RecordsInMemory>();
    BuiltBlocks built = build_blocks(mesh, options, *records);
    blocks_->numbers = std::move(built.numbers);
    blocks_->counts = built.counts;
    blocks_->source = std::move(records);
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

// The blocks of a ring ascend, except from the last to the first. Therefore a walk ends if no step passes `start`.
void Topology::Blocks::check_ring(BorderVertex at, BorderVertex next, Index start) const {
    const bool onwards =
        at.block < start ? next.block > at.block && next.block <= start : next.block > at.block || next.block <= start;
    if (!onwards || cells(at.block).vertex(vertex_at(at)) != cells(next.block).vertex(vertex_at(next)))
        fail("the blocks " + std::to_string(at.block) + " and " + std::to_string(next.block) +
             " of the mesh contradict each other about a vertex that they share; import the dataset again");
}

// A changed 32-bit id may lead to any address. Therefore records with such ids are copied, and the copies are checked.
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
