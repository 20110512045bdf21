// Volume-weighted sums of cell gradients at a vertex (paper, section 3), and iteration over the cells around a vertex.
#pragma once

#include "blocks/blocks.hpp"
#include "blocks/load_vertices.hpp"
#include "ciel/values_view.hpp"
#include "fields/cell_gradient.hpp"

#include <algorithm>

namespace ciel::detail {

struct GradientSum {
    Four weighted{}; // elements 0 to 2: sum of gradient * volume; element 3: sum of volumes

    void add(const CellGradient& cell) {
        const double volume = cell.volume;
        weighted += Four{volume * cell.gradient[0], volume * cell.gradient[1], volume * cell.gradient[2], volume};
    }
    void add(const GradientSum& other) { weighted += other.weighted; }
    [[nodiscard]] Vec3f mean() const {
        const double volume = weighted[3];
        if (!(volume > 0)) return {};
        return {static_cast<float>(weighted[0] / volume), static_cast<float>(weighted[1] / volume),
                static_cast<float>(weighted[2] / volume)};
    }
};

// Returns the Sample of a local vertex of a block.
class BlockSampler {
public:
    // Loads the positions of the block's vertices. `b`: number of the block. `values`: by local vertex.
    BlockSampler(const FaceMeshView& mesh, Index b, const Block& block, ValuesView values)
        : mesh_(mesh), block_(block), values_(values) {
        load_vertices(mesh.loader, b, block);
    }

    // Like BlockSampler, for values and positions whose number types are template arguments.
    template <class Value, class Position>
    class Typed {
    public:
        Typed(const Block& block, const Position* positions, const Value* values)
            : block_(block), ghosts_(static_cast<Index>(block.ghost_vertex.size())),
              own_(block.own_vertex_begin - ghosts_), positions_(positions), values_(values) {}
        [[nodiscard]] Sample operator()(Index local) const {
            return sample(local,
                          local < ghosts_ ? block_.ghost_vertex[local] : std::min(own_ + local, block_.last_vertex));
        }
        void range(Index begin, Index end, Sample* out) const {
            for (; begin < std::min(end, ghosts_); ++begin) out[begin] = sample(begin, block_.ghost_vertex[begin]);
            for (; begin < end; ++begin) out[begin] = sample(begin, own_ + begin);
        }

    private:
        [[nodiscard]] Sample sample(Index local, Index vertex) const {
            const Position* p = &positions_[3 * std::size_t{vertex}];
            return {p[0], p[1], p[2], values_[local]};
        }

        const Block& block_;
        // An owned vertex has the mesh id own_ + its local id. The sum is modulo 2^32, so own_ may stand for a number
        // below 0.
        Index ghosts_, own_;
        const Position* positions_; // by mesh vertex
        const Value* values_;       // by local vertex
    };
    template <class F>
    decltype(auto) with(F&& f) const {
        return values_.with([&](const auto& values) -> decltype(auto) {
            return mesh_.positions.with([&](const auto& positions) -> decltype(auto) {
                return f(Typed(block_, positions.data(), values.data()));
            });
        });
    }

    [[nodiscard]] Sample operator()(Index local) const {
        return with([&](const auto& typed) { return typed(local); });
    }

    void all(std::vector<Sample>& out) const { of_parts(~std::uint64_t{0}, out); }
    // Sets out[v] only for the vertices v of the parts whose bit in `parts` is set (Block::vertices_per_part).
    void of_parts(std::uint64_t parts, std::vector<Sample>& out) const {
        out.resize(block_.vertex_count);
        with([&](const auto& typed) {
            const Index in_part = block_.vertices_per_part();
            for (Index begin = 0; begin < block_.vertex_count; begin += in_part, parts >>= 1)
                if ((parts & 1) != 0) typed.range(begin, std::min(begin + in_part, block_.vertex_count), out.data());
        });
    }

private:
    const FaceMeshView& mesh_;
    const Block& block_;
    ValuesView values_;
};

// Returns the local vertices of a standard cell. `vertex`: the first corner of the cell in its section. An id of a
// changed record that is not a vertex of the block is replaced by the last vertex, so that each result can be an index
// into an array by local vertex.
template <const StandardShape& shape>
[[nodiscard]] std::array<std::uint16_t, shape.corners> corners_of(const Block& block, const std::uint16_t* vertex) {
    const auto last = static_cast<std::uint16_t>(std::min<std::size_t>(block.vertex_count, local_ids) - 1);
    std::array<std::uint16_t, shape.corners> corners;
    for (std::size_t c = 0; c < shape.corners; ++c) {
        const std::uint16_t v = vertex[c]; // a copy, read only once; std::min would return a reference to the record
        corners[c] = v < last ? v : last;
    }
    return corners;
}

template <const StandardShape& shape, class Sampler>
[[nodiscard]] CellGradient cell_gradient(const std::uint16_t* vertex, const Sampler& sample) {
    std::array<Sample, shape.corners> samples;
    for (std::size_t c = 0; c < shape.corners; ++c) samples[c] = sample(vertex[c]);
    return standard_gradient<shape>(samples);
}

// Sets `out` to the blocks that have a border vertex, ascending, each with the local id of the vertex.
inline void list_ring(const Topology::Blocks& blocks, BorderVertex at, std::vector<BlockVertex>& out) {
    out.clear();
    const Index start = at.block;
    std::size_t lowest = 0;
    do {
        if (!out.empty() && at.block < out[lowest].block) lowest = out.size();
        out.push_back({at.block, blocks.vertex_at(at)});
        at = blocks.next_in_ring(at, start);
    } while (at.block != start);
    std::rotate(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(lowest), out.end());
}

// Calls visit.template standard<shape>(block, section, i, place) for standard cells, in the order of (type, cell), then
// visit.polyhedron(block, i, place) once for each polyhedron, ascending. `ring`: from list_ring. `i`: index of the cell
// in its section. `place`: index of the cell in the concatenated sections of its block.
template <class Visit>
void for_cells_around(const Topology::Blocks& blocks, std::span<const BlockVertex> ring, std::vector<Index>& scratch,
                      Visit&& visit) {
    std::array<bool, standard_types.size()> has_type{};
    bool has_polyhedra = false;
    for (const BlockVertex at : ring) {
        const Block& block = blocks.cells(at.block);
        for (const StandardSection& section : block.standard) has_type[place_of_type(section.shape->type)] = true;
        has_polyhedra = has_polyhedra || block.with([](const auto& section) { return section.count() > 0; });
    }
    const auto standard = [&]<const StandardShape & shape>() {
        if (!has_type[place_of_type(shape.type)]) return;
        for (const BlockVertex at : ring) {
            const Block& block = blocks.cells(at.block);
            const BlockAround& around = blocks.around(at.block);
            Index place = 0;
            for (std::size_t s = 0; s < block.standard.size(); ++s) {
                const StandardSection& section = block.standard[s];
                if (section.shape != &shape) {
                    place += section.count();
                    continue;
                }
                const Index end = section.entry_begin + static_cast<Index>(section.vertex.size());
                Index entry = first_entry_from(block, around, at.vertex, section.entry_begin);
                for (; entry < end; entry = next_entry(around.next_entry[s], entry, section.entry_begin)) {
                    const Index i = (entry - section.entry_begin) / shape.corners;
                    visit.template standard<shape>(at.block, section, i, place + i);
                }
            }
        }
    };
    standard.template operator()<tetrahedron_shape>();
    standard.template operator()<hexahedron_shape>();
    standard.template operator()<wedge_shape>();
    standard.template operator()<pyramid_shape>();
    if (!has_polyhedra) return;
    for (const BlockVertex at : ring) {
        const Block& block = blocks.cells(at.block);
        const BlockAround& around = blocks.around(at.block);
        with_around(block, around, [&](const auto& polyhedra, const auto& arrays) {
            scratch.clear();
            for (Index entry = first_entry_from(block, around, at.vertex, polyhedra.entry_begin);
                 entry != arrays.end_of_list; entry = next_entry(arrays.next_entry, entry, polyhedra.entry_begin))
                for (const Index i : polyhedra.face_cell[polyhedra.face(entry - polyhedra.entry_begin)])
                    scratch.push_back(i);
            std::ranges::sort(scratch);
            scratch.erase(std::unique(scratch.begin(), scratch.end()), scratch.end());
            if (!scratch.empty() && scratch.back() >= polyhedra.count())
                refuse_changed("a face refers to a cell that does not exist");
            const Index place = block.cell_count - polyhedra.count();
            for (const Index i : scratch) visit.polyhedron(at.block, i, place + i);
        });
    }
}

// Visitor for for_cells_around that adds the gradients of cells that are already solved. `stored(block, place)` returns
// a pointer to the gradient. Throws Error if the pointer is null, because the ring of the vertex has then changed.
template <class Stored>
class AddStored {
public:
    explicit AddStored(Stored stored) : stored_(stored) {}

    template <const StandardShape& shape>
    void standard(Index b, const StandardSection&, Index, Index place) {
        add(b, place);
    }
    void polyhedron(Index b, Index, Index place) { add(b, place); }

    GradientSum sum;

private:
    void add(Index b, Index place) {
        const CellGradient* cell = stored_(b, place);
        if (cell == nullptr) [[unlikely]]
            refuse_changed("a border vertex leads to another cell than before");
        sum.add(*cell);
    }

    Stored stored_;
};

} // namespace ciel::detail
