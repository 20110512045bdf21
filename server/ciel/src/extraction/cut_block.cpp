#include "extraction/active_edges.hpp"
#include "extraction/classify_vertices.hpp"
#include "parallel/vector_units.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>

namespace ciel::detail {

namespace {

template <class T>
void grow(std::vector<T>& room, std::size_t size) {
    if (room.size() < size) room.resize(size);
}

bool crosses(const CellRanges::Range& range, double threshold) { return range[0] < threshold && range[1] >= threshold; }

template <std::size_t corners>
Index high_corners(const std::uint16_t* vertex, const std::uint8_t* high) {
    Index bits = 0;
    for (std::size_t c = 0; c < corners; ++c) bits |= Index{high[vertex[c]]} << c;
    return bits;
}

// Has no branch, because branches on active cells are mispredicted.
template <std::size_t corners>
void list_active(const StandardSection& section, Index begin, Index end, CutScratch& scratch) {
    constexpr Index all = (Index{1} << corners) - 1;
    const std::uint16_t* vertex = section.vertex.data();
    const std::uint8_t* high = scratch.high.data();
    CutScratch::ActiveCell* to = scratch.cell.data() + scratch.cells;
    for (Index i = begin; i < end; ++i) {
        const Index bits = high_corners<corners>(vertex + i * corners, high);
        *to = {i, bits};
        to += bits != 0 && bits != all ? 1 : 0;
    }
    scratch.cells = static_cast<Index>(to - scratch.cell.data());
}

// A group of cells has vertices in few parts, and most parts are all low or all high, so most groups are skipped.
// The padding after the last vertex counts as low; at worst, a group without active cells is searched.
void find_parts(const Block& block, CutScratch& scratch) {
    constexpr std::uint64_t all_high = 0x0101010101010101U;
    const Index step = block.vertices_per_part();
    scratch.low_parts = scratch.high_parts = 0;
    for (Index begin = 0, part = 0; begin < block.vertex_count; begin += step, ++part) {
        std::uint64_t any = 0, all = all_high;
        for (Index v = begin; v < std::min(begin + step, block.vertex_count); v += 8) {
            std::uint64_t eight;
            std::memcpy(&eight, scratch.high.data() + v, sizeof eight);
            any |= eight;
            all &= eight;
        }
        scratch.high_parts |= std::uint64_t{any != 0} << part;
        scratch.low_parts |= std::uint64_t{all != all_high} << part;
    }
}

template <class T>
void fetch(const T* from, std::size_t count) {
    for (std::size_t i = 0; i < count; i += 64 / sizeof(T)) __builtin_prefetch(from + i);
}

void find_active(const StandardSection& section, const BlockValues& in, std::span<const CellRanges::Range> groups,
                 CutScratch& scratch) {
    scratch.cells = 0;
    const auto may_be_active = [&](Index g) {
        if (!groups.empty()) return crosses(groups[g], in.threshold);
        const std::uint64_t parts = section.group_parts[g];
        return (parts & scratch.low_parts) != 0 && (parts & scratch.high_parts) != 0;
    };
    constexpr Index step = StandardSection::cells_per_group, ahead = 8;
    with_shape(section.shape->type, [&]<const StandardShape & shape>() {
        for (Index g = 0; g < section.group_count(); ++g) {
            if (g + ahead < section.group_count() && may_be_active(g + ahead))
                fetch(&section.vertex[(g + ahead) * step * shape.corners], step * shape.corners);
            if (may_be_active(g))
                list_active<shape.corners>(section, g * step, std::min((g + 1) * step, section.count()), scratch);
        }
    });
}

// Compares 64 corners at a time, because a loop over the corners of each face mispredicts branches.
template <class Local>
void find_crossed(const PolyhedralSection<Local>& section, CutScratch& scratch) {
    const std::size_t corners = section.vertex.size();
    const Local* vertex = section.vertex.data();
    const std::uint8_t* high = scratch.high.data();
    grow(scratch.crossed_cells, std::max<std::size_t>(section.count(), local_ids) / 64 + 1);
    std::ranges::fill(scratch.crossed_cells, std::uint64_t{0});
    const auto cross = [&](Index face) {
        if (face >= section.face_count()) refuse_changed("a face does not exist");
        for (const Local& side : section.face_cell[face]) {
            const Index cell = read_once(side);
            scratch.crossed_cells[cell / 64] |= std::uint64_t{1} << cell % 64;
        }
    };
    std::uint64_t before = 0; // 1 if the last corner of the previous 64 corners is high
    Index last = none;
    for (std::size_t w = 0, begin = 0; begin < corners; ++w, begin += 64) {
        const std::uint64_t parts =
            section.corner_parts.empty() ? ~std::uint64_t{0} : read_once(section.corner_parts[w]);
        const std::size_t count = std::min<std::size_t>(64, corners - begin);
        std::uint64_t here = 0;
        if ((parts & scratch.low_parts) == 0) {
            here = ~std::uint64_t{0};
        } else if ((parts & scratch.high_parts) != 0) {
            std::array<std::uint8_t, 64> bytes{};
            for (std::size_t i = 0; i < count; ++i) bytes[i] = high[vertex[begin + i]];
            for (std::size_t i = 0; i < 8; ++i) here |= bits_of(&bytes[8 * i]) << 8 * i;
        }
        std::uint64_t differ = (here ^ (here << 1 | before)) & ~read_once(section.face_start[w]);
        if (count < 64) differ &= (std::uint64_t{1} << count) - 1;
        before = here >> 63;
        for (; differ != 0; differ &= differ - 1) {
            const Index face = section.face(static_cast<Index>(begin) + static_cast<Index>(std::countr_zero(differ)));
            if (face != last) cross(face);
            last = face;
        }
    }
}

template <class Local>
void find_active(const PolyhedralSection<Local>& section, const BlockValues& in,
                 std::span<const CellRanges::Range> ranges, CutScratch& scratch) {
    scratch.cells = 0;
    if (!ranges.empty()) {
        for (Index cell = 0; cell < section.count(); ++cell)
            if (crosses(ranges[cell], in.threshold)) scratch.cell[scratch.cells++] = {cell, 0};
        return;
    }
    if (section.count() == 0) return;
    find_crossed(section, scratch);
    for (Index begin = 0; begin < section.count(); begin += 64) {
        std::uint64_t cells = scratch.crossed_cells[begin / 64];
        if (section.count() - begin < 64) cells &= (std::uint64_t{1} << (section.count() - begin)) - 1;
        for (; cells != 0; cells &= cells - 1)
            scratch.cell[scratch.cells++] = {begin + static_cast<Index>(std::countr_zero(cells)), 0};
    }
}

// Branch-free loops write an entry after the last active entry, so scratch.ends and scratch.cell get an extra entry.
void begin_cut(const Block& block, CutScratch& scratch, ActiveBlock& cut) {
    grow(scratch.ends, std::max<std::size_t>(block.edge_count, local_ids) + 1);
    grow(scratch.cell, block.cell_count + std::size_t{1});
    cut.polygon_cell.clear();
    cut.polygon_end.clear();
    cut.polygon_edge.clear();
    cut.wasted = false;
    cut.decided = false;
}

// Sorts the polygons by cell. On entry, they are sorted by section, and by cell in each section.
void sort_polygons(CutScratch& scratch, ActiveBlock& cut) {
    auto& [order, cell, end, edge] = scratch.sorted;
    order.resize(cut.polygon_cell.size());
    std::iota(order.begin(), order.end(), Index{0});
    std::ranges::sort(order, [&](Index p, Index q) {
        return cut.polygon_cell[p] != cut.polygon_cell[q] ? cut.polygon_cell[p] < cut.polygon_cell[q] : p < q;
    });
    cell.clear();
    end.clear();
    edge.clear();
    for (const Index p : order) {
        cell.push_back(cut.polygon_cell[p]);
        const Index begin = p == 0 ? 0 : cut.polygon_end[p - 1];
        edge.insert(edge.end(), cut.polygon_edge.begin() + begin, cut.polygon_edge.begin() + cut.polygon_end[p]);
        end.push_back(static_cast<Index>(edge.size()));
    }
    cut.polygon_cell.assign(cell.begin(), cell.end());
    cut.polygon_end.assign(end.begin(), end.end());
    cut.polygon_edge.assign(edge.begin(), edge.end());
}

CIEL_FOR_ALL_VECTOR_UNITS Index rank_active(const std::uint64_t* active, std::size_t words, Index* rank) {
    Index count = 0;
    for (std::size_t w = 0; w < words; ++w) {
        rank[w] = count;
        count += static_cast<Index>(std::popcount(active[w]));
    }
    return count;
}

// A section without a list of cells needs no check, because its cell numbers do not come from the record.
void check_cells(const Block& block, const ActiveBlock& cut) {
    const auto lists_cells = [](const auto& section) { return !section.cell.empty(); };
    if (!std::ranges::any_of(block.standard, lists_cells) && !block.with(lists_cells)) return;
    const Index cells = block.cell_count;
    Index outside = 0;
    for (const Index cell : cut.polygon_cell) outside |= cell >= cells ? 1U : 0U;
    if (outside != 0) refuse_changed("a cell does not exist");
}

// This check covers the polygons, because every edge of a polygon is active.
void check_edges(const Block& block, CutScratch& scratch) {
    const std::size_t words = (block.edge_count + std::size_t{63}) / 64;
    const Index rest = block.edge_count % 64;
    std::uint64_t outside = rest == 0 ? 0 : scratch.active[words - 1] >> rest;
    // An id of 16 bits cannot set a bit after these words. Ids of 32 bits cannot change (block.hpp).
    for (std::size_t w = words; w < local_ids / 64; ++w) outside |= scratch.active[w];
    if (outside != 0) refuse_changed("an edge does not exist");
    scratch.active_words = words;
}

void begin_shared(const Block& block, CutScratch& scratch, ActiveBlock& cut) {
    begin_cut(block, scratch, cut);
    std::fill_n(scratch.active.begin(), scratch.active_words, std::uint64_t{0});
    grow(scratch.active, std::max((block.edge_count + std::size_t{63}) / 64, local_ids / 64));
    scratch.active_words = scratch.active.size(); // all words, in case the cut throws before check_edges
}

void list_edges(const Block& block, CutScratch& scratch, ActiveBlock& cut) {
    check_cells(block, cut);
    check_edges(block, scratch);
    const auto words = static_cast<std::ptrdiff_t>(scratch.active_words);
    cut.active.assign(scratch.active.begin(), scratch.active.begin() + words);
    cut.rank.resize(cut.active.size());
    cut.ends.resize(rank_active(cut.active.data(), cut.active.size(), cut.rank.data()));
    std::array<Index, 2>* to = cut.ends.data();
    const Index vertices = block.vertex_count;
    Index outside = 0;
    for (std::size_t w = 0; w < cut.active.size(); ++w)
        for (std::uint64_t bits = cut.active[w]; bits != 0; bits &= bits - 1) {
            *to = scratch.ends[64 * w + static_cast<std::size_t>(std::countr_zero(bits))];
            outside |= std::max((*to)[0], (*to)[1]) >= vertices ? 1U : 0U;
            ++to;
        }
    if (outside != 0) refuse_changed("an edge has an end that does not exist");
    const auto count = static_cast<Index>(cut.ends.size());
    cut.ghosts = count == 0 || block.ghost_edge.size() == block.edge_count
                     ? count
                     : cut.place(static_cast<Index>(block.ghost_edge.size()));
}

template <class Edges>
void cut_sections(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut) {
    if (in.naive)
        scratch.low_parts = scratch.high_parts = ~std::uint64_t{0};
    else if (in.ranges.empty())
        find_parts(block, scratch);
    std::size_t first = 0;
    for (const StandardSection& section : block.standard) {
        const std::size_t groups = section.group_count();
        find_active(section, in, in.ranges.empty() ? in.ranges : in.ranges.subspan(first, groups), scratch);
        first += groups;
        cut_standard<Edges>(section, in, scratch, cut);
    }
    block.with([&](const auto& polyhedra) {
        find_active(polyhedra, in, in.ranges.empty() ? in.ranges : in.ranges.subspan(first), scratch);
        cut_polyhedra<Edges>(polyhedra, in, scratch, cut);
    });
    if (!std::ranges::is_sorted(cut.polygon_cell)) sort_polygons(scratch, cut);
}

template <class Edges>
void cut_listed(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                ActiveBlock& cut) {
    const auto for_each_in = [&](const auto& section, auto&& found) {
        scratch.cells = 0;
        for (const Index cell : cells) {
            if (section.cell.empty()) {
                if (section.count() > 0) found(cell);
                continue;
            }
            const auto at = std::ranges::lower_bound(section.cell, cell);
            if (at != section.cell.end() && *at == cell) found(static_cast<Index>(at - section.cell.begin()));
        }
    };
    for (const StandardSection& section : block.standard) {
        with_shape(section.shape->type, [&]<const StandardShape & shape>() {
            for_each_in(section, [&](Index i) { list_active<shape.corners>(section, i, i + 1, scratch); });
        });
        cut_standard<Edges>(section, in, scratch, cut);
    }
    block.with([&](const auto& polyhedra) {
        for_each_in(polyhedra, [&](Index i) { scratch.cell[scratch.cells++] = {i, 0}; });
        cut_polyhedra<Edges>(polyhedra, in, scratch, cut);
    });
    if (!std::ranges::is_sorted(cut.polygon_cell)) sort_polygons(scratch, cut);
}

void begin_cut_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut) {
    begin_cut(block, scratch, cut);
    const Index most = std::max(block.edge_count, Index{local_ids});
    grow(scratch.met, most);
    (void)mark_vertices(in.values, in.threshold, scratch);
    // Skips all numbers that the previous cut may have used, even if it threw an exception.
    scratch.met_before += scratch.met_most;
    scratch.met_most = most;
    scratch.met_count = 0;
    if (scratch.met_before > none - most) {
        std::ranges::fill(scratch.met, Index{0});
        scratch.met_before = 1;
    }
}

} // namespace

void cut_block(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut) {
    begin_shared(block, scratch, cut);
    cut_sections<SharedEdges>(block, in, scratch, cut);
    list_edges(block, scratch, cut);
}

void cut_cells(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
               ActiveBlock& cut) {
    begin_shared(block, scratch, cut);
    cut_listed<SharedEdges>(block, in, cells, scratch, cut);
    list_edges(block, scratch, cut);
}

void cut_block_alone(const Block& block, const BlockValues& in, CutScratch& scratch, ActiveBlock& cut) {
    begin_cut_alone(block, in, scratch, cut);
    cut_sections<MetEdges>(block, in, scratch, cut);
    check_cells(block, cut);
}

void cut_cells_alone(const Block& block, const BlockValues& in, std::span<const Index> cells, CutScratch& scratch,
                     ActiveBlock& cut) {
    begin_cut_alone(block, in, scratch, cut);
    cut_listed<MetEdges>(block, in, cells, scratch, cut);
    check_cells(block, cut);
}

} // namespace ciel::detail
