#include "blocks/block_tables.hpp"

#include <string>

namespace ciel::detail {

namespace {

// Ids of the sections of the tables. An id never changes its meaning, because files store the ids.
enum Id : std::uint16_t { id_counts = 1, id_cell, id_vertex, id_edge, id_slot, id_half_edges, id_border_vertices };

constexpr auto kind = static_cast<RecordKind>(0x6c626174); // "tabl"; no record of a block has this kind

[[noreturn]] void refuse(const char* what) {
    fail(std::string("the index of the blocks is damaged: ") + what + "; import the dataset again");
}

std::vector<Index> read_prefix(const RecordView& record, Id id, std::size_t blocks) {
    const auto stored = record.get<std::uint64_t>(id);
    if (stored.size() != blocks + 1 || stored.front() != 0 || !std::ranges::is_sorted(stored))
        refuse("the first ids of the blocks do not ascend");
    if (stored.back() >= none) fail("the mesh has more than 4,294,967,294 cells, vertices or edges; split the dataset");
    return {stored.begin(), stored.end()};
}

} // namespace

RecordBytes tables_of(const BlockNumbers& numbers, const TopologyCounts& counts) {
    const std::array<std::uint64_t, 7> list{counts.vertices,       counts.edges, counts.faces,     counts.half_edges,
                                            counts.boundary_faces, counts.cells, counts.components};
    const auto wide = [](const std::vector<Index>& narrow) {
        return std::vector<std::uint64_t>(narrow.begin(), narrow.end());
    };
    const auto cell = wide(numbers.cell), vertex = wide(numbers.vertex), edge = wide(numbers.edge),
               slot = wide(numbers.slot);
    RecordWriter writer;
    writer.add(id_counts, std::span<const std::uint64_t>(list));
    writer.add(id_cell, std::span<const std::uint64_t>(cell));
    writer.add(id_vertex, std::span<const std::uint64_t>(vertex));
    writer.add(id_edge, std::span<const std::uint64_t>(edge));
    writer.add(id_slot, std::span<const std::uint64_t>(slot));
    writer.add(id_half_edges, std::span<const Index>(numbers.half_edges));
    writer.add(id_border_vertices, std::span<const Index>(numbers.border_vertices));
    return writer.finish(kind);
}

void read_tables(std::span<const std::byte> bytes, BlockNumbers& numbers, TopologyCounts& counts) {
    const RecordView record(bytes, kind);
    const auto list = record.get<std::uint64_t>(id_counts);
    if (list.size() != 7) refuse("it has no counts");
    counts = {list[0], list[1], list[2], list[3], list[4], list[5], list[6]};
    const auto half_edges = record.get<Index>(id_half_edges), border = record.get<Index>(id_border_vertices);
    if (half_edges.size() != border.size()) refuse("its tables have different sizes");
    numbers = {};
    if (half_edges.empty()) {
        if (counts.cells != 0) refuse("it has no blocks");
        record.check_all_known();
        return;
    }
    numbers.half_edges.assign(half_edges.begin(), half_edges.end());
    numbers.border_vertices.assign(border.begin(), border.end());
    numbers.cell = read_prefix(record, id_cell, half_edges.size());
    numbers.vertex = read_prefix(record, id_vertex, half_edges.size());
    numbers.edge = read_prefix(record, id_edge, half_edges.size());
    numbers.slot = read_prefix(record, id_slot, half_edges.size());
    record.check_all_known();
    std::uint64_t sum = 0;
    for (const Index of_block : half_edges) sum += of_block;
    if (sum != counts.half_edges || numbers.cell.back() != counts.cells || numbers.edge.back() != counts.edges ||
        numbers.vertex.back() > counts.vertices)
        refuse("its counts are not the sums over the blocks");
    for (std::size_t b = 0; b < half_edges.size(); ++b)
        if (numbers.vertex[b + 1] - numbers.vertex[b] > numbers.slot[b + 1] - numbers.slot[b])
            refuse("a block owns more vertices than it has");
}

} // namespace ciel::detail
