#include "blocks/block_builder.hpp"

#include <algorithm>

namespace ciel::detail {

BuiltBlock BlockBuilder::build(Index cell_begin, Index cell_end) {
    loops_.gather(cell_begin, cell_end);
    anchor_.assign(loops_.loop_count(), {none, none});
    BuiltBlock built;
    built.block.cell_begin = cell_begin;
    built.block.cell_count = cell_end - cell_begin;
    built.block.vertex_count = static_cast<Index>(loops_.vertices.size());
    built.block.edge_count = static_cast<Index>(loops_.edge_ends.size());
    sort_cells();
    if (fits_16_bits())
        fill<std::uint16_t>(built);
    else
        fill<std::uint32_t>(built);
    built.vertices = loops_.vertices;
    built.edge_ends = loops_.edge_ends;
    return built;
}

CellType BlockBuilder::type_of(Index local_cell) const {
    const auto refs = loops_.of_cell(local_cell);
    std::size_t half_edges = 0, largest = 0;
    for (const LoopRef ref : refs) {
        const std::size_t size = loops_.size(ref);
        half_edges += size;
        largest = std::max(largest, size);
    }
    return type_of_faces(refs.size(), half_edges, largest);
}

void BlockBuilder::sort_cells() {
    for (auto& cells : standard_) cells.clear();
    polyhedra_.clear();
    for (Index cell = 0; cell < loops_.cell_end - loops_.cell_begin; ++cell) {
        const CellType type = type_of(cell);
        StandardCell found;
        bool fits = false;
        with_shape(type, [&]<const StandardShape & shape>() { fits = recognise<shape>(loops_, cell, found); });
        if (fits)
            standard_[place_of_type(type)].push_back({cell, found});
        else
            polyhedra_.push_back(cell);
    }
}

// Half-edges and twins must fit together, because BlockMatesOf::mate numbers the twins after the half-edges.
bool BlockBuilder::fits_16_bits() const {
    constexpr std::size_t limit = no_mate;
    std::vector<std::uint8_t> is_polyhedron(loops_.cell_end - loops_.cell_begin, 0);
    for (const Index cell : polyhedra_) is_polyhedron[cell] = 1;
    std::size_t entries = 0, half_edges = 0;
    for (std::size_t type = 0; type < standard_types.size(); ++type)
        with_shape(standard_types[type], [&]<const StandardShape & shape>() {
            entries += standard_[type].size() * shape.corners;
            half_edges += standard_[type].size() * shape.half_edges;
        });
    for (Index loop = 0; loop < loops_.loop_count(); ++loop)
        for (const Index side : {0U, 1U}) {
            const Index cell = loops_.cell_on(loop, side);
            if (cell == none || is_polyhedron[cell] == 0) continue;
            entries += loops_.begin[loop + 1] - loops_.begin[loop];
            break;
        }
    return entries < limit && half_edges + loops_.loop_count() < limit &&
           2 * std::size_t{loops_.loop_count()} < limit && loops_.vertices.size() < limit &&
           loops_.edge_ends.size() < limit;
}

template <class Local>
void BlockBuilder::fill(BuiltBlock& built) {
    if (sizeof(Local) > sizeof(std::uint16_t)) { // standard sections have 16-bit ids, so all cells become polyhedra
        for (auto& cells : standard_) cells.clear();
        polyhedra_.resize(built.block.cell_count);
        for (Index cell = 0; cell < polyhedra_.size(); ++cell) polyhedra_[cell] = cell;
    }
    for (std::size_t type = 0; type < standard_types.size(); ++type)
        if (!standard_[type].empty())
            with_shape(standard_types[type],
                       [&]<const StandardShape & shape>() { fill_standard<shape>(built, standard_[type]); });
    built.block.standard_half_edges = built.block.half_edge_count;
    fill_polyhedra<Local>(loops_, polyhedra_, built, anchor_);
    set_standard_mates(built);
    Index entries = 0;
    for (StandardSectionOf<Owned>& section : built.block.standard) {
        section.entry_begin = entries;
        entries += static_cast<Index>(section.vertex.size());
    }
    std::get<PolyhedralSection<Local, Owned>>(built.block.polyhedra).entry_begin = entries;
    list_entries<Local>(built.block, built.around);
}

template <const StandardShape& shape>
void BlockBuilder::fill_standard(BuiltBlock& built, std::span<const Recognised> cells) {
    StandardSectionOf<Owned>& section = built.block.standard.emplace_back();
    section.shape = &shape;
    section.cells = static_cast<Index>(cells.size());
    section.half_edge_begin = built.block.half_edge_count;
    built.block.half_edge_count += static_cast<Index>(cells.size()) * shape.half_edges;
    if (cells.size() != built.block.cell_count) section.cell.reserve(cells.size());
    section.vertex.reserve(cells.size() * shape.corners);
    section.edge.resize(cells.size() * shape.edges);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const StandardCell& cell = cells[i].found;
        if (cells.size() != built.block.cell_count) section.cell.push_back(static_cast<std::uint16_t>(cells[i].cell));
        for (std::size_t c = 0; c < shape.corners; ++c)
            section.vertex.push_back(static_cast<std::uint16_t>(cell.corner[c]));
        for (std::size_t h = 0; h < shape.half_edges; ++h) {
            const std::size_t face = shape.face[h];
            const Index n = shape.face_size(face);
            const auto at = static_cast<Index>((cell.turn[face] + h - shape.face_begin[face]) % n);
            section.edge[i * shape.edges + shape.edge[h]] =
                static_cast<std::uint16_t>(loops_.edge_at(cell.loop[face], at));
        }
    }
    const Index part = built.block.vertices_per_part();
    section.group_parts.resize(section.group_count(), 0);
    for (std::size_t i = 0; i < section.vertex.size(); ++i)
        section.group_parts[i / (std::size_t{StandardSection::cells_per_group} * shape.corners)] |=
            std::uint64_t{1} << section.vertex[i] / part;
    set_anchors<shape>(cells, section.half_edge_begin);
}

template <const StandardShape& shape>
void BlockBuilder::set_anchors(std::span<const Recognised> cells, Index half_edge_begin) {
    for (const Recognised& cell : cells) {
        for (std::size_t face = 0; face < shape.faces; ++face) {
            const LoopRef ref = cell.found.loop[face];
            const Index n = shape.face_size(face);
            const Index place = (ref % 2 == 0 ? n : 2 * n - 2) - cell.found.turn[face];
            anchor_[ref / 2][ref % 2] = half_edge_begin + shape.face_begin[face] + place % n;
        }
        half_edge_begin += shape.half_edges;
    }
}

void BlockBuilder::set_standard_mates(BuiltBlock& built) {
    for (const StandardSectionOf<Owned>& section : built.block.standard) {
        const StandardShape& shape = *section.shape;
        const std::size_t type = place_of_type(shape.type);
        std::vector<std::uint16_t>& mates = built.mates.mate.emplace_back();
        mates.reserve(standard_[type].size() * shape.faces);
        Index first = section.half_edge_begin;
        for (const Recognised& cell : standard_[type]) {
            for (std::size_t face = 0; face < shape.faces; ++face) {
                const Index loop = cell.found.loop[face] / 2, side = cell.found.loop[face] % 2;
                const Index steps = anchor_[loop][side] - first - shape.face_begin[face];
                const Index other = anchor_[loop][1 - side];
                if (other < built.block.standard_half_edges) {
                    mates.push_back(static_cast<std::uint16_t>(turn(built.block, other, steps)));
                } else if (side == 0 && loops_.is_boundary(loop)) {
                    mates.push_back(no_mate);
                } else {
                    mates.push_back(static_cast<std::uint16_t>(built.block.standard_half_edges + built.tails.size()));
                    built.tails.push_back({loops_.mesh_face[loop], side, loops_.mesh_cell[loop][1 - side],
                                           anchor_[loop][side], steps, other});
                }
            }
            first += shape.half_edges;
        }
    }
}

// Goes from the last entry to the first, so that each list ascends.
template <class Local>
void BlockBuilder::list_entries(const BlockOf<Owned>& block, BlockAroundOf<Owned>& around) {
    auto& arrays = around.arrays.emplace<AroundArrays<Local, Owned>>();
    constexpr Local end = AroundArrays<Local, Owned>::end_of_list;
    arrays.first_entry.assign(block.vertex_count, end);
    const auto link = [&](const auto& vertex, auto& next_entry, Index entry_begin) {
        next_entry.resize(vertex.size());
        for (std::size_t k = vertex.size(); k-- > 0;) {
            next_entry[k] = static_cast<std::decay_t<decltype(next_entry[k])>>(arrays.first_entry[vertex[k]]);
            arrays.first_entry[vertex[k]] = static_cast<Local>(entry_begin + k);
        }
    };
    const auto& polyhedra = std::get<PolyhedralSection<Local, Owned>>(block.polyhedra);
    link(polyhedra.vertex, arrays.next_entry, polyhedra.entry_begin);
    around.next_entry.resize(block.standard.size());
    for (std::size_t i = block.standard.size(); i-- > 0;)
        link(block.standard[i].vertex, around.next_entry[i], block.standard[i].entry_begin);
}

} // namespace ciel::detail
