#include "blocks/check_records.hpp"

#include "blocks/pair_half_edges.hpp"

#include <string>

namespace ciel::detail {

namespace {

class Checker {
public:
    explicit Checker(Index number) : number_(number) {}

    void require(bool holds, const char* what) const {
        if (!holds)
            fail("block " + std::to_string(number_) + " of the mesh is damaged: " + what +
                 "; import the dataset again");
    }
    template <class Ids>
    void below(const Ids& ids, std::size_t limit, const char* what) const {
        bool inside = true; // no branch in the loop, so that the check costs little more than reading
        for (const auto id : ids) inside &= id < limit;
        require(inside, what);
    }

private:
    Index number_;
};

class EdgeEnds {
public:
    explicit EdgeEnds(Index edges) : ends_(edges, unknown) {}

    // Returns false if the edge does not exist, a equals b, or an earlier call gave the edge other ends.
    [[nodiscard]] bool agrees(Index edge, Index a, Index b) {
        if (edge >= ends_.size()) return false; // the record changed after its ids were checked
        const std::uint64_t here = std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
        std::uint64_t& known = ends_[edge];
        if (known == unknown) known = here;
        return a != b && known == here;
    }

private:
    static constexpr std::uint64_t unknown = ~std::uint64_t{0};
    std::vector<std::uint64_t> ends_; // both ends in one number, which is faster to compare than two
};

template <class Section>
void check_cell_list(const Checker& checker, const Section& section, const Block& block) {
    if (section.cell.empty()) {
        checker.require(section.count() == 0 || section.count() == block.cell_count,
                        "a section has no list of its cells");
        return;
    }
    checker.require(section.cell.size() == section.count(), "the list of a section's cells has a wrong length");
    checker.require(std::adjacent_find(section.cell.begin(), section.cell.end(), std::greater_equal<>()) ==
                            section.cell.end() &&
                        section.cell.back() < block.cell_count,
                    "the cells of a section do not ascend");
}

void check_standard(const Checker& checker, const StandardSection& section, const Block& block, EdgeEnds& ends) {
    const StandardShape& of_section = *section.shape;
    const std::size_t cells = section.cells;
    checker.require(cells <= local_ids && section.vertex.size() == cells * of_section.corners &&
                        section.edge.size() == cells * of_section.edges &&
                        section.group_parts.size() == section.group_count(),
                    "the sizes of a section's arrays contradict each other");
    check_cell_list(checker, section, block);
    checker.below(section.vertex, block.vertex_count, "a cell has a vertex that the block does not have");
    checker.below(section.edge, block.edge_count, "a cell has an edge that the block does not have");
    bool agree = true;
    with_shape(of_section.type, [&]<const StandardShape & shape>() {
        for (std::size_t i = 0; i < cells; ++i)
            for (std::size_t e = 0; e < shape.edges; ++e)
                agree &= ends.agrees(read_once(section.edge[i * shape.edges + e]),
                                     section.vertex[i * shape.corners + shape.edge_ends[e][0]],
                                     section.vertex[i * shape.corners + shape.edge_ends[e][1]]);
    });
    checker.require(agree, "two cells disagree about the ends of an edge");
}

// Requires steps of at least `least` from 0 to `end`. Also checks their number, because entries may change meanwhile.
template <class Array>
void check_begins(const Checker& checker, const Array& begin, std::size_t end, std::size_t least, const char* what) {
    bool ascend = begin.front() == 0 && begin.back() == end;
    for (std::size_t i = 1; i < begin.size(); ++i) ascend &= begin[i] >= begin[i - 1] + least;
    checker.require(ascend && (begin.size() - 1) * least <= end, what);
}

template <class Local>
void check_face_starts(const Checker& checker, const PolyhedralSection<Local>& section) {
    const std::size_t corners = section.vertex.size(), words = (corners + 63) / 64;
    checker.require(section.face_start.size() == words && section.face_rank.size() == words &&
                        (section.corner_parts.empty() || section.corner_parts.size() == words),
                    "the table of face starts has a wrong size");
    std::vector<std::uint64_t> start(words, 0);
    bool agree = true;
    for (Index f = 0; f < section.face_count(); ++f) {
        const Index begin = read_once(section.face_begin[f]);
        agree &= begin < corners;
        if (begin < corners) start[begin / 64] |= std::uint64_t{1} << begin % 64;
    }
    Index rank = 0;
    for (std::size_t w = 0; w < words; ++w) {
        agree &= section.face_start[w] == start[w] && section.face_rank[w] == rank;
        rank += static_cast<Index>(std::popcount(start[w]));
    }
    checker.require(agree, "the table of face starts contradicts the faces");
}

template <class Local>
void check_face_cells(const Checker& checker, const PolyhedralSection<Local>& section) {
    checker.require(section.face_cell.size() == section.face_count(),
                    "the number of faces contradicts the list of their cells");
    for (const auto& [near, far] : section.face_cell)
        checker.require(near < section.count() && far < section.count(), "a face refers to a cell that does not exist");
    checker.below(section.cell_face, 2 * std::size_t{section.face_count()},
                  "a cell refers to a face that does not exist");
    for (Index i = 0; i < section.count(); ++i)
        for (const Index ref : section.faces_of(i)) {
            const Index face = ref / 2, side = ref % 2;
            const Index of_tail = Index{section.face_begin[face] >= section.far_corner};
            checker.require(section.face_cell[face][side] == i && (face < section.inner_faces || side == of_tail),
                            "a cell has a face that does not refer to the cell");
        }
}

template <class Local>
void check_polyhedra(const Checker& checker, const PolyhedralSection<Local>& section, const Block& block,
                     EdgeEnds& ends) {
    const std::size_t corners = section.vertex.size();
    check_cell_list(checker, section, block);
    checker.require(section.edge.size() == corners && section.face_begin.empty() == section.cell_face_begin.empty(),
                    "the sizes of the arrays of polyhedra contradict each other");
    if (section.cell_face_begin.empty()) {
        checker.require(corners == 0 && section.cell_face.empty() && section.inner_corners == 0 &&
                            section.inner_faces == 0,
                        "there are faces without a cell");
        return;
    }
    check_begins(checker, section.face_begin, corners, 2, "the list of the faces' first corners is wrong");
    // The least step is 0, because a cell that collapsed to a point has no faces.
    check_begins(checker, section.cell_face_begin, section.cell_face.size(), 0,
                 "the list of the cells' first faces is wrong");
    checker.require(section.inner_faces <= section.face_count() &&
                        section.face_begin[section.inner_faces] == section.inner_corners &&
                        section.inner_corners <= section.far_corner && section.far_corner <= corners &&
                        std::ranges::binary_search(section.face_begin, section.far_corner),
                    "the limits between inner faces and tail faces are wrong");
    check_face_starts(checker, section);
    check_face_cells(checker, section);
    checker.below(section.vertex, block.vertex_count, "a face has a vertex that the block does not have");
    checker.below(section.edge, block.edge_count, "a face has an edge that the block does not have");
    bool agree = true;
    section.for_corners([&](Index face, Index k) {
        agree &=
            ends.agrees(read_once(section.edge[k]), section.vertex[k], section.vertex[section.next_in_loop(k, face)]);
    });
    checker.require(agree, "two faces disagree about the ends of an edge");
    HalfEdgePairs pairs;
    Index left = section.half_edge_count();
    for (Index i = 0; i < section.count(); ++i)
        checker.require(pairs.run(section, i, left, [](Index, Index, Index) {}), "a cell is not closed");
}

// The owner of each ghost must come before block `number`. `begin`: first id that each block owns.
void check_ghosts(const Checker& checker, const Ghosts& ghosts, std::span<const Index> begin, Index number) {
    Index last = none, owner = none, first = 0, count = 0; // count: number of ids that `owner` owns
    const auto check = [&](Index neighbour, Index index) {
        if (neighbour != owner) {
            checker.require(neighbour < ghosts.begin.size(), "the owner of a ghost vertex or edge is not a neighbor");
            first = ghosts.begin[neighbour];
            const auto next = std::ranges::upper_bound(begin, first);
            checker.require(next != begin.end(), "the owner of a ghost vertex or edge is not a neighbor");
            owner = neighbour;
            count = *next - first;
        }
        checker.require(index < count, "the owner of a ghost vertex or edge does not have it");
        const Index id = first + index;
        checker.require(id < begin[number] && (last == none || id > last), "the ghost vertices or edges do not ascend");
        last = id;
    };
    for (const auto& [neighbour, index] : ghosts.narrow) check(read_once(neighbour), read_once(index));
    for (const auto& [neighbour, index] : ghosts.wide) check(read_once(neighbour), read_once(index));
}

Index difference(const std::vector<Index>& begin, Index number) { return begin[number + 1] - begin[number]; }

} // namespace

void check_cells(const Block& block, Index number, const BlockNumbers& numbers) {
    const Checker checker(number);
    checker.require(block.cell_count == difference(numbers.cell, number) &&
                        block.vertex_count == difference(numbers.slot, number) &&
                        block.half_edge_count == numbers.half_edges[number],
                    "its number of cells, vertices or half-edges differs from the number in the index");
    checker.require(block.ghost_vertex.size() + difference(numbers.vertex, number) == block.vertex_count &&
                        block.ghost_edge.size() + difference(numbers.edge, number) == block.edge_count,
                    "its number of owned vertices or edges differs from the number in the index");
    check_ghosts(checker, block.ghost_vertex, numbers.vertex, number);
    check_ghosts(checker, block.ghost_edge, numbers.edge, number);
    EdgeEnds ends(block.edge_count);
    std::size_t cells = 0;
    for (const StandardSection& section : block.standard) {
        check_standard(checker, section, block, ends);
        cells += section.count();
    }
    block.with([&](const auto& polyhedra) {
        check_polyhedra(checker, polyhedra, block, ends);
        cells += polyhedra.count();
    });
    checker.require(cells == block.cell_count, "its sections have more or fewer cells than the block");
}

namespace {

std::vector<Index> vertices_by_entry(const Block& block) {
    std::vector<Index> vertices;
    for (const StandardSection& section : block.standard)
        vertices.insert(vertices.end(), section.vertex.begin(), section.vertex.end());
    block.with([&](const auto& polyhedra) {
        vertices.insert(vertices.end(), polyhedra.vertex.begin(), polyhedra.vertex.end());
    });
    return vertices;
}

} // namespace

void check_around(const Block& block, const BlockAround& around, Index number, const BlockNumbers& numbers) {
    const Checker checker(number);
    const std::vector<Index> vertices = vertices_by_entry(block);
    with_around(block, around, [&](const auto& polyhedra, const auto& all) {
        const Index end = all.end_of_list;
        const auto leads_on = [&](Index entry, Index vertex) {
            return entry == end || (entry < vertices.size() && vertices[entry] == vertex);
        };
        checker.require(all.first_entry.size() == block.vertex_count &&
                            all.next_entry.size() == polyhedra.vertex.size(),
                        "the lists of entries have wrong sizes");
        bool lead = true;
        for (Index v = 0; v < block.vertex_count; ++v) lead &= leads_on(read_once(all.first_entry[v]), v);
        const auto check_list = [&](const auto& next, Index begin) {
            for (Index k = 0; k < next.size(); ++k)
                lead &= next[k] > begin + k && leads_on(read_once(next[k]), vertices[begin + k]);
        };
        for (std::size_t s = 0; s < block.standard.size(); ++s) {
            checker.require(around.next_entry[s].size() == block.standard[s].vertex.size(),
                            "the lists of entries have wrong sizes");
            check_list(around.next_entry[s], block.standard[s].entry_begin);
        }
        check_list(all.next_entry, polyhedra.entry_begin);
        checker.require(lead, "a list of entries does not ascend, or leads to another vertex");
        const std::size_t border = all.border_vertex.size();
        checker.require(border == numbers.border_vertices[number] && all.border_block.size() == border &&
                            all.border_place.size() == border,
                        "its number of border vertices differs from the number in the index");
        checker.require(std::adjacent_find(all.border_vertex.begin(), all.border_vertex.end(),
                                           std::greater_equal<>()) == all.border_vertex.end() &&
                            (border == 0 || all.border_vertex.back() < block.vertex_count),
                        "the border vertices do not ascend");
        bool inside = true;
        for (std::size_t i = 0; i < border; ++i) {
            const Index next = read_once(all.border_block[i]);
            checker.require(next < around.neighbour.size(), "a border vertex leads to a block that is not a neighbor");
            inside &= all.border_place[i] < numbers.border_vertices[around.neighbour[next]];
        }
        checker.require(inside, "a border vertex leads to a vertex that the neighbor does not share");
    });
}

void check_mates(const Block& block, const BlockMates& mates, Index number, const BlockNumbers& numbers) {
    const Checker checker(number);
    const std::size_t twins = mates.twin_half_edge.size();
    for (std::size_t s = 0; s < block.standard.size(); ++s) {
        checker.require(mates.mate[s].size() == std::size_t{block.standard[s].cells} * block.standard[s].shape->faces,
                        "the number of mates contradicts the number of cells");
        bool inside = true;
        for (const std::uint16_t mate : mates.mate[s])
            inside &= mate == no_mate || mate < block.standard_half_edges + twins;
        checker.require(inside, "a mate does not exist");
    }
    with_mates(block, mates, [&](const auto& polyhedra, const auto& all) {
        const std::size_t half_edges = polyhedra.vertex.size() + polyhedra.inner_corners;
        const std::size_t tails = polyhedra.face_count() - polyhedra.inner_faces;
        checker.require(all.twin_block.size() == twins && mates.twin_begin <= twins &&
                            tails <= twins - mates.twin_begin && all.mate_face.size() == (half_edges + 1) / 2,
                        "the number of mates contradicts the number of faces");
        bool inside = true;
        for (std::size_t i = 0; i < twins; ++i) {
            const Index there = read_once(all.twin_block[i]);
            inside &= there == all.no_block || (there < mates.neighbour.size() &&
                                                mates.twin_half_edge[i] < numbers.half_edges[mates.neighbour[there]]);
        }
        checker.require(inside, "a mate in another block or section does not exist");
        bool ascend = true;
        Index last = none;
        for (const auto& [half_edge, mate] : all.mate_escapes) {
            ascend &= (last == none || half_edge > last) && half_edge < half_edges && mate < half_edges;
            last = half_edge;
        }
        checker.require(ascend, "the list of mates does not ascend, or a mate does not exist");
        for (Index h = 0; h < half_edges; ++h)
            checker.require(all.mate_bits(h) != all.escape ||
                                std::ranges::binary_search(all.mate_escapes, h, {}, &MateEscape::half_edge),
                            "a mate is missing in the list of mates");
    });
}

} // namespace ciel::detail
