#include "blocks/block_records.hpp"

#include <iterator>
#include <string>

namespace ciel::detail {

namespace {

// Ids of the sections of records. An id never changes its meaning, because files store the ids.
enum Id : std::uint16_t {
    id_neighbour = 1, // i32: number of the other block - number of this block
    // In a record of the kind RecordKind::cells:
    id_counts = 2,       // u32: the members of Counts
    id_ghost_vertex = 3, // by ghost: (neighbor, index among the vertices that the neighbor owns)
    id_ghost_edge = 4,   // likewise, with edges
    id_face_begin = 32,
    id_face_cell,
    id_face_start,
    id_face_rank,
    id_cell_face_begin,
    id_cell_face,
    id_corner_parts,
    // In a record of the kind RecordKind::around:
    id_first_entry = 8,
    id_border_vertex,
    id_border_block,
    id_border_place,
    // In a record of the kind RecordKind::mates:
    id_twin_counts = 16, // u32: twin_begin
    id_twin_block,
    id_twin_half_edge,
    id_mate_face,
    id_mate_escape,
    // Each of these ids starts a range: one id for each type in the order of standard_types, then one for polyhedra.
    id_cell = 48,
    id_vertex = 56,
    id_edge = 64,
    id_group_parts = 72,
    id_next_entry = 80,
    id_mate = 88
};

constexpr std::uint16_t of_polyhedra = 4;

struct Counts {
    Index cells, vertices, edges, inner_corners, far_corner, inner_faces;
};

std::uint16_t type_id(Id first, std::size_t type) { return static_cast<std::uint16_t>(first + type); }

template <class T>
std::span<const T> span_of(const std::vector<T>& vector) {
    return vector;
}

[[noreturn]] void refuse(const char* what) {
    fail(std::string("a record of a block is damaged: ") + what + "; import the dataset again");
}

std::vector<std::int32_t> distances(std::span<const Index> neighbours, Index number) {
    std::vector<std::int32_t> out;
    for (const Index other : neighbours)
        out.push_back(static_cast<std::int32_t>(static_cast<std::int64_t>(other) - number));
    return out;
}

std::vector<Index> blocks_at(std::span<const std::int32_t> distances, Index number, std::size_t count) {
    std::vector<Index> out;
    for (const std::int32_t distance : distances) {
        const std::int64_t other = std::int64_t{number} + distance;
        if (other < 0 || other >= static_cast<std::int64_t>(count)) refuse("it refers to a block that does not exist");
        out.push_back(static_cast<Index>(other));
    }
    return out;
}

// Returns the blocks that own the ghosts `ids`. Both are in ascending order. `begin`: first id that each block owns.
std::vector<Index> owners_of(std::span<const Index> ids, std::span<const Index> begin) {
    std::vector<Index> owners;
    for (const Index id : ids)
        if (owners.empty() || id >= begin[owners.back() + 1])
            owners.push_back(static_cast<Index>(std::ranges::upper_bound(begin, id) - begin.begin() - 1));
    return owners;
}

NamedGhosts named(std::span<const Index> ids, std::span<const Index> neighbours, std::span<const Index> begin) {
    NamedGhosts out;
    std::size_t at = 0;
    for (const Index id : ids) {
        while (id >= begin[neighbours[at] + 1]) ++at;
        out.wide.push_back({static_cast<std::uint32_t>(at), id - begin[neighbours[at]]});
    }
    const bool fit = std::ranges::all_of(out.wide, [](const auto& ghost) {
        return std::max(ghost[0], ghost[1]) <= std::numeric_limits<std::uint16_t>::max();
    });
    if (!fit) return out;
    for (const auto& [neighbour, index] : out.wide)
        out.narrow.push_back({static_cast<std::uint16_t>(neighbour), static_cast<std::uint16_t>(index)});
    out.wide = {};
    return out;
}

void add_ghosts(RecordWriter& writer, std::uint16_t id, const NamedGhosts& ghosts) {
    writer.add(id, span_of(ghosts.narrow));
    writer.add(id, span_of(ghosts.wide));
}

Ghosts view_ghosts(const RecordView& record, std::uint16_t id, std::span<const Index> neighbours,
                   std::span<const Index> begin) {
    Ghosts ghosts;
    if (record.element_size(id) == sizeof ghosts.wide[0])
        ghosts.wide = record.get<std::array<std::uint32_t, 2>>(id);
    else
        ghosts.narrow = record.get<std::array<std::uint16_t, 2>>(id);
    ghosts.begin.reserve(neighbours.size());
    for (const Index neighbour : neighbours) ghosts.begin.push_back(begin[neighbour]);
    ghosts.last = begin.back() - 1;
    return ghosts;
}

} // namespace

BlockGhosts name_ghosts(const BlockOf<Owned>& block, std::span<const Index> vertex_begin,
                        std::span<const Index> edge_begin) {
    BlockGhosts out;
    std::ranges::set_union(owners_of(block.ghost_vertex, vertex_begin), owners_of(block.ghost_edge, edge_begin),
                           std::back_inserter(out.neighbours));
    out.vertices = named(block.ghost_vertex, out.neighbours, vertex_begin);
    out.edges = named(block.ghost_edge, out.neighbours, edge_begin);
    return out;
}

RecordBytes record_of(const BlockOf<Owned>& block, const BlockGhosts& ghosts, Index number) {
    return block.with([&]<class Local>(const PolyhedralSection<Local, Owned>& polyhedra) {
        const auto away = distances(ghosts.neighbours, number);
        const Counts counts{block.cell_count,        block.vertex_count,   block.edge_count,
                            polyhedra.inner_corners, polyhedra.far_corner, polyhedra.inner_faces};
        RecordWriter writer;
        writer.add(id_neighbour, span_of(away));
        writer.add(id_counts, std::span(&counts.cells, sizeof counts / sizeof(Index)));
        add_ghosts(writer, id_ghost_vertex, ghosts.vertices);
        add_ghosts(writer, id_ghost_edge, ghosts.edges);
        for (const StandardSectionOf<Owned>& section : block.standard) {
            const std::size_t type = place_of_type(section.shape->type);
            writer.add(type_id(id_cell, type), span_of(section.cell));
            writer.add(type_id(id_vertex, type), span_of(section.vertex));
            writer.add(type_id(id_edge, type), span_of(section.edge));
            writer.add(type_id(id_group_parts, type), span_of(section.group_parts));
        }
        writer.add(type_id(id_cell, of_polyhedra), span_of(polyhedra.cell));
        writer.add(type_id(id_vertex, of_polyhedra), span_of(polyhedra.vertex));
        writer.add(type_id(id_edge, of_polyhedra), span_of(polyhedra.edge));
        writer.add(id_face_begin, span_of(polyhedra.face_begin));
        writer.add(id_face_cell, span_of(polyhedra.face_cell));
        writer.add(id_face_start, span_of(polyhedra.face_start));
        writer.add(id_face_rank, span_of(polyhedra.face_rank));
        writer.add(id_cell_face_begin, span_of(polyhedra.cell_face_begin));
        writer.add(id_cell_face, span_of(polyhedra.cell_face));
        writer.add_optional(id_corner_parts, span_of(polyhedra.corner_parts));
        return writer.finish(RecordKind::cells);
    });
}

RecordBytes record_of(const BlockAroundOf<Owned>& around, std::span<const CellType> types, Index number) {
    const auto away = distances(around.neighbour, number);
    RecordWriter writer;
    writer.add(id_neighbour, span_of(away));
    for (std::size_t s = 0; s < types.size(); ++s)
        writer.add(type_id(id_next_entry, place_of_type(types[s])), span_of(around.next_entry[s]));
    return around.with([&](const auto& all) {
        writer.add(type_id(id_next_entry, of_polyhedra), span_of(all.next_entry));
        writer.add(id_first_entry, span_of(all.first_entry));
        writer.add(id_border_vertex, span_of(all.border_vertex));
        writer.add(id_border_block, span_of(all.border_block));
        writer.add(id_border_place, span_of(all.border_place));
        return writer.finish(RecordKind::around);
    });
}

RecordBytes record_of(const BlockMatesOf<Owned>& mates, std::span<const CellType> types, Index number) {
    const auto away = distances(mates.neighbour, number);
    RecordWriter writer;
    writer.add(id_neighbour, span_of(away));
    writer.add(id_twin_counts, std::span(&mates.twin_begin, 1));
    for (std::size_t s = 0; s < types.size(); ++s)
        writer.add(type_id(id_mate, place_of_type(types[s])), span_of(mates.mate[s]));
    writer.add(id_twin_half_edge, span_of(mates.twin_half_edge));
    return std::visit(
        [&](const auto& all) {
            writer.add(id_mate_face, span_of(all.mate_face));
            writer.add(id_mate_escape, span_of(all.mate_escapes));
            writer.add(id_twin_block, span_of(all.twin_block));
            return writer.finish(RecordKind::mates);
        },
        mates.arrays);
}

namespace {

template <class Local>
void view_polyhedra(const RecordView& record, const Counts& counts, PolyhedralSection<Local>& out) {
    out.inner_corners = counts.inner_corners;
    out.far_corner = counts.far_corner;
    out.inner_faces = counts.inner_faces;
    out.cell = record.get<Local>(type_id(id_cell, of_polyhedra));
    out.vertex = record.get<Local>(type_id(id_vertex, of_polyhedra));
    out.edge = record.get<Local>(type_id(id_edge, of_polyhedra));
    out.face_begin = record.get<Local>(id_face_begin);
    out.face_cell = record.get<std::array<Local, 2>>(id_face_cell);
    out.face_start = record.get<std::uint64_t>(id_face_start);
    out.face_rank = record.get<Local>(id_face_rank);
    out.cell_face_begin = record.get<Local>(id_cell_face_begin);
    out.cell_face = record.get<Local>(id_cell_face);
    out.corner_parts = record.get<std::uint64_t>(id_corner_parts);
}

void view_standard(const RecordView& record, std::size_t type, Block& block, Index& entries) {
    const auto vertex = record.get<std::uint16_t>(type_id(id_vertex, type));
    if (vertex.empty()) return;
    StandardSection& section = block.standard.emplace_back();
    with_shape(standard_types[type], [&]<const StandardShape & shape>() { section.shape = &shape; });
    section.cells = static_cast<Index>(vertex.size() / section.shape->corners);
    section.half_edge_begin = block.half_edge_count;
    section.entry_begin = entries;
    section.cell = record.get<std::uint16_t>(type_id(id_cell, type));
    section.vertex = vertex;
    section.edge = record.get<std::uint16_t>(type_id(id_edge, type));
    section.group_parts = record.get<std::uint64_t>(type_id(id_group_parts, type));
    block.half_edge_count += section.cells * section.shape->half_edges;
    entries += static_cast<Index>(vertex.size());
}

} // namespace

Block view_cells(std::span<const std::byte> bytes, Index number, const BlockNumbers& numbers) {
    const RecordView record(bytes, RecordKind::cells);
    const auto list = record.get<Index>(id_counts);
    if (list.size() != sizeof(Counts) / sizeof(Index)) refuse("it has no counts");
    const Counts counts{list[0], list[1], list[2], list[3], list[4], list[5]};
    Block block;
    block.cell_begin = numbers.cell[number];
    block.cell_count = counts.cells;
    block.edge_begin = numbers.edge[number];
    block.edge_count = counts.edges;
    block.vertex_begin = numbers.slot[number];
    block.vertex_count = counts.vertices;
    block.own_vertex_begin = numbers.vertex[number];
    block.last_vertex = numbers.vertex.back() - 1;
    block.last_edge = numbers.edge.back() - 1;
    const std::vector<Index> neighbours =
        blocks_at(record.get<std::int32_t>(id_neighbour), number, numbers.block_count());
    block.ghost_vertex = view_ghosts(record, id_ghost_vertex, neighbours, numbers.vertex);
    block.ghost_edge = view_ghosts(record, id_ghost_edge, neighbours, numbers.edge);
    Index entries = 0;
    for (std::size_t type = 0; type < standard_types.size(); ++type) view_standard(record, type, block, entries);
    block.standard_half_edges = block.half_edge_count;
    const auto of_size = [&]<class Local>(Local) {
        auto& polyhedra = block.polyhedra.emplace<PolyhedralSection<Local>>();
        view_polyhedra(record, counts, polyhedra);
        polyhedra.half_edge_begin = block.half_edge_count;
        polyhedra.entry_begin = entries;
        block.half_edge_count += polyhedra.half_edge_count();
    };
    if (record.element_size(type_id(id_vertex, of_polyhedra)) == sizeof(std::uint32_t))
        of_size(std::uint32_t{});
    else
        of_size(std::uint16_t{});
    record.check_all_known();
    return block;
}

BlockAround view_around(std::span<const std::byte> bytes, Index number, const BlockNumbers& numbers,
                        const Block& block) {
    const RecordView record(bytes, RecordKind::around);
    BlockAround around;
    around.neighbour = blocks_at(record.get<std::int32_t>(id_neighbour), number, numbers.block_count());
    for (const StandardSection& section : block.standard)
        around.next_entry.push_back(
            record.get<std::uint16_t>(type_id(id_next_entry, place_of_type(section.shape->type))));
    block.with([&]<class Local>(const PolyhedralSection<Local>&) {
        auto& all = around.arrays.emplace<AroundArrays<Local>>();
        all.next_entry = record.get<Local>(type_id(id_next_entry, of_polyhedra));
        all.first_entry = record.get<Local>(id_first_entry);
        all.border_vertex = record.get<Local>(id_border_vertex);
        all.border_block = record.get<Local>(id_border_block);
        all.border_place = record.get<Local>(id_border_place);
    });
    record.check_all_known();
    return around;
}

BlockMates view_mates(std::span<const std::byte> bytes, Index number, const BlockNumbers& numbers, const Block& block) {
    const RecordView record(bytes, RecordKind::mates);
    const auto counts = record.get<Index>(id_twin_counts);
    if (counts.size() != 1) refuse("it has no counts");
    BlockMates mates;
    mates.twin_begin = counts[0];
    mates.neighbour = blocks_at(record.get<std::int32_t>(id_neighbour), number, numbers.block_count());
    mates.twin_half_edge = record.get<Index>(id_twin_half_edge);
    for (const StandardSection& section : block.standard)
        mates.mate.push_back(record.get<std::uint16_t>(type_id(id_mate, place_of_type(section.shape->type))));
    block.with([&]<class Local>(const PolyhedralSection<Local>&) {
        auto& all = mates.arrays.emplace<MateArrays<Local>>();
        all.mate_face = record.get<std::uint8_t>(id_mate_face);
        all.mate_escapes = record.get<MateEscape>(id_mate_escape);
        all.twin_block = record.get<Local>(id_twin_block);
    });
    record.check_all_known();
    return mates;
}

} // namespace ciel::detail
