#include "fields/gradient.hpp"

#include "ciel/of_this_thread.hpp"
#include "ciel/parallel.hpp"
#include "fields/cell_fits.hpp"
#include "fields/field_data.hpp"
#include "fields/gradient_sums.hpp"
#include "fields/many_gradients.hpp"
#include "fields/solved_cells.hpp"

#include <atomic>
#include <cstring>

namespace ciel::detail {

namespace {

constexpr std::size_t blocks_per_task = 2;
// If at most this many vertices of a block need a gradient, the cells around each vertex are solved separately.
constexpr std::size_t few = 12;

enum State : std::uint8_t { wanted = 1, asked_by_neighbour = 2, known = 4 };

struct Scratch {
    std::vector<Sample> sample; // by local vertex
    std::vector<Index> wanted, cells;
    std::vector<BlockVertex> ring;
    PolyhedronFitter fitter;
    std::vector<Sample> stretched;
    // For the block whose cells are solved:
    std::vector<Index> asked;            // vertices with the flag `wanted` or asked_by_neighbour, ascending
    std::uint64_t asked_parts = 0;       // bit p is set if part p of the block has one of these vertices
    std::vector<Index> slot;             // by local vertex: index in `sum`, 0 for vertices that are not wanted
    std::vector<GradientSum> sum;        // sum[0]: terms of vertices that are not wanted; never read
    std::vector<std::uint64_t> to_solve; // one bit per cell of the PolyhedralSection
    std::vector<std::uint16_t> corners;  // local vertices of the corners of the cells to solve
    std::vector<CellGradient> gradients; // one gradient per cell to solve
    SolvedCells solved;                  // copied to Pass::solved_ without spare capacity
};

Scratch& gradient_scratch() { return of_this_thread<Scratch>(); }

struct AddSolved {
    const FaceMeshView& mesh;
    const Field::Data& field;
    Scratch& scratch;
    GradientSum sum;

    [[nodiscard]] BlockSampler sampler(Index b) const {
        return {mesh, b, field.topology->blocks().cells(b), field.of_block(b)};
    }
    template <const StandardShape& shape>
    void standard(Index b, const StandardSection& section, Index i, Index) {
        sum.add(cell_gradient<shape>(&section.vertex[i * shape.corners], sampler(b)));
    }
    void polyhedron(Index b, Index i, Index) {
        const Block& block = field.topology->blocks().cells(b);
        sampler(b).with([&](const auto& sample) {
            block.with([&](const auto& section) {
                with_fits(field.shared_fits(mesh), b, block, section, sample, scratch.fitter,
                          [&](auto&& fitted) { sum.add(fitted_gradient(fitted(i), sample, scratch.stretched)); });
            });
        });
    }
};

// Computes the gradients at the wanted vertices: ends of active edges whose gradients are not yet known. In a block
// with more than `few` of them, solves each needed cell once, then sums at the vertices that several blocks have.
class Pass {
public:
    Pass(const FaceMeshView& mesh, const Field::Data& field, std::span<std::uint8_t> state,
         std::span<std::uint8_t> busy, std::span<std::unique_ptr<Vec3f[]>> gradient)
        : mesh_(mesh), field_(field), blocks_(field.topology->blocks()), state_(state), busy_(busy),
          gradient_(gradient) {}

    void run(std::span<const Index> active, const BlockCuts& cut) {
        for_each(active, [&](Index b) { want(b, cut[b]); });
        std::vector<Index> busy;
        for (Index b = 0; b < busy_.size(); ++b)
            if (busy_[b] != 0) busy.push_back(b);
        if (busy.empty()) return;
        solved_.resize(blocks_.count());
        for_each(busy, [this](Index b) { sum_inside(b); });
        for_each(active, [this](Index b) { sum_at_border(b); });
        for_each(busy, [this](Index b) { settle(b); });
    }

private:
    template <class F>
    void for_each(std::span<const Index> blocks, F&& body) {
        parallel_for(blocks.size(), blocks_per_task, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) body(blocks[i]);
        });
    }
    // Atomic, because two tasks may set the same gradient if the file of a record is changed while it is used.
    void set_gradient(const BlockVertex& at, const Vec3f& to) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            std::atomic_ref(gradient_[at.block][at.vertex][axis]).store(to[axis], std::memory_order_relaxed);
    }
    [[nodiscard]] std::span<std::uint8_t> states(const Block& block) const {
        return state_.subspan(block.vertex_begin, block.vertex_count);
    }
    void mark_busy(Index b) { std::atomic_ref(busy_[b]).store(1, std::memory_order_relaxed); }

    void want(Index b, const ActiveBlock& cut);
    void solve_one_by_one(Index b, std::span<const Index> vertices);
    void ask_neighbours(Index b);
    void list_asked(const Block& block, Scratch& scratch) const;
    void sum_inside(Index b);
    template <const StandardShape& shape>
    void add_standard(const BlockSampler& sampler, const Block& block, const StandardSection& section, Index place);
    template <class Local>
    void add_polyhedra(const BlockSampler& sampler, Index b, const PolyhedralSection<Local>& section);
    template <class Local>
    void mark_polyhedra(Index b, const PolyhedralSection<Local>& section, Scratch& scratch) const;
    void sum_at_border(Index b);
    void settle(Index b);

    const FaceMeshView& mesh_;
    const Field::Data& field_;
    const Topology::Blocks& blocks_;
    std::span<std::uint8_t> state_;
    std::span<std::uint8_t> busy_; // by block: 1 if it has cells to solve
    std::span<std::unique_ptr<Vec3f[]>> gradient_;
    std::vector<SolvedCells> solved_; // by block
};

void Pass::want(Index b, const ActiveBlock& cut) {
    const Block& block = blocks_.cells(b);
    if (gradient_[b] == nullptr) gradient_[b] = std::make_unique_for_overwrite<Vec3f[]>(block.vertex_count);
    const std::span<std::uint8_t> state = states(block);
    std::vector<Index>& found = gradient_scratch().wanted;
    found.clear();
    const auto want_both = [&](const std::array<Index, 2>& ends) {
        for (const Index v : ends) {
            // Atomic, because the task of another block may set asked_by_neighbour at the same time.
            std::atomic_ref here(state[v]);
            if ((here.load(std::memory_order_relaxed) & (known | wanted)) != 0) continue;
            here.fetch_or(wanted, std::memory_order_relaxed);
            found.push_back(v);
        }
    };
    std::ranges::for_each(std::span(cut.ends).subspan(cut.ghosts), want_both);
    for (const Index ghost : cut.adopted) want_both(cut.ends[ghost]);
    if (found.empty()) return;
    if (found.size() <= few) return solve_one_by_one(b, found);
    mark_busy(b);
    ask_neighbours(b);
}

void Pass::solve_one_by_one(Index b, std::span<const Index> vertices) {
    const Block& block = blocks_.cells(b);
    Scratch& scratch = gradient_scratch();
    for (const Index v : vertices) {
        const Index place = blocks_.around(b).border_place_of(v);
        if (place == none)
            scratch.ring.assign(1, {b, v});
        else
            list_ring(blocks_, {b, place}, scratch.ring);
        AddSolved add{mesh_, field_, scratch, {}};
        for_cells_around(blocks_, scratch.ring, scratch.cells, add);
        gradient_[b][v] = add.sum.mean();
        std::atomic_ref state(states(block)[v]);
        state.fetch_xor(wanted | known, std::memory_order_relaxed);
    }
}

void Pass::ask_neighbours(Index b) {
    const Block& block = blocks_.cells(b);
    const std::span<std::uint8_t> state = states(block);
    blocks_.around(b).with([&](const auto& arrays) {
        for (Index place = 0; place < arrays.border_vertex.size(); ++place) {
            const Index v = std::min<Index>(read_once(arrays.border_vertex[place]), block.vertex_count - 1);
            if ((std::atomic_ref(state[v]).load(std::memory_order_relaxed) & wanted) == 0) continue;
            for (BorderVertex at = blocks_.next_in_ring({b, place}, b); at.block != b;
                 at = blocks_.next_in_ring(at, b)) {
                std::atomic_ref(states(blocks_.cells(at.block))[blocks_.vertex_at(at)])
                    .fetch_or(asked_by_neighbour, std::memory_order_relaxed);
                mark_busy(at.block);
            }
        }
    });
}

void Pass::list_asked(const Block& block, Scratch& scratch) const {
    const std::span<const std::uint8_t> state = states(block);
    const Index in_part = block.vertices_per_part();
    constexpr std::uint64_t any = (wanted | asked_by_neighbour) * 0x0101010101010101;
    scratch.asked.clear();
    scratch.asked_parts = 0;
    scratch.slot.assign(block.vertex_count, 0);
    scratch.sum.assign(1, {});
    const auto look_at = [&](Index v) {
        if ((state[v] & (wanted | asked_by_neighbour)) == 0) return;
        scratch.asked.push_back(v);
        scratch.asked_parts |= std::uint64_t{1} << v / in_part;
        if ((state[v] & wanted) == 0) return;
        scratch.slot[v] = static_cast<Index>(scratch.sum.size());
        scratch.sum.emplace_back();
    };
    Index v = 0;
    for (; v + 8 <= block.vertex_count; v += 8) {
        std::uint64_t eight;
        std::memcpy(&eight, &state[v], sizeof eight);
        if ((eight & any) == 0) continue;
        for (Index i = 0; i < 8; ++i) look_at(v + i);
    }
    for (; v < block.vertex_count; ++v) look_at(v);
}

void Pass::sum_inside(Index b) {
    const Block& block = blocks_.cells(b);
    Scratch& scratch = gradient_scratch();
    const BlockSampler sampler(mesh_, b, block, field_.of_block(b));
    list_asked(block, scratch);
    scratch.solved.begin(block.cell_count);
    Index place = 0;
    for (const StandardSection& section : block.standard) {
        with_shape(section.shape->type,
                   [&]<const StandardShape & shape>() { add_standard<shape>(sampler, block, section, place); });
        place += section.count();
    }
    block.with([&](const auto& polyhedra) { add_polyhedra(sampler, b, polyhedra); });
    solved_[b] = scratch.solved;
    for (const Index v : scratch.asked)
        if (scratch.slot[v] != 0) gradient_[b][v] = scratch.sum[scratch.slot[v]].mean();
}

template <const StandardShape& shape>
void Pass::add_standard(const BlockSampler& sampler, const Block& block, const StandardSection& section, Index place) {
    Scratch& scratch = gradient_scratch();
    const std::span<const std::uint8_t> state = states(block);
    constexpr Index in_group = StandardSection::cells_per_group;
    scratch.cells.clear();
    scratch.corners.clear();
    std::uint64_t parts = 0;
    for (Index group = 0; group < section.group_count(); ++group) {
        const std::uint64_t of_group = read_once(section.group_parts[group]);
        if ((of_group & scratch.asked_parts) == 0) continue;
        const std::size_t before = scratch.cells.size();
        for (Index i = group * in_group; i < std::min((group + 1) * in_group, section.count()); ++i) {
            const auto vertex = corners_of<shape>(block, &section.vertex[std::size_t{i} * shape.corners]);
            unsigned states = 0;
            for (std::size_t c = 0; c < shape.corners; ++c) states |= state[vertex[c]];
            if ((states & (wanted | asked_by_neighbour)) == 0) continue;
            scratch.cells.push_back(i);
            for (const std::uint16_t v : vertex) scratch.corners.push_back(v);
        }
        if (scratch.cells.size() > before) parts |= of_group;
    }
    sampler.of_parts(parts, scratch.sample);
    scratch.gradients.resize(scratch.cells.size());
    many_gradients(shape.type, scratch.corners, scratch.sample, scratch.gradients);
    const std::uint16_t* vertex = scratch.corners.data();
    for (std::size_t at = 0; at < scratch.cells.size(); ++at, vertex += shape.corners) {
        const CellGradient& cell = scratch.gradients[at];
        scratch.solved.add(place + scratch.cells[at], cell);
        GradientSum weighted;
        weighted.add(cell);
        for (std::size_t c = 0; c < shape.corners; ++c) scratch.sum[scratch.slot[vertex[c]]].add(weighted);
    }
}

// Marks the polyhedra around the vertices in `asked`. Visits only the entries of these vertices, because they are few.
template <class Local>
void Pass::mark_polyhedra(Index b, const PolyhedralSection<Local>& section, Scratch& scratch) const {
    const Block& block = blocks_.cells(b);
    const BlockAround& around = blocks_.around(b);
    scratch.to_solve.assign((section.count() + 63) / 64, 0);
    const auto& next = std::get<AroundArrays<Local>>(around.arrays).next_entry;
    constexpr Index end_of_list = AroundArrays<Local>::end_of_list;
    for (const Index v : scratch.asked)
        for (Index entry = first_entry_from(block, around, v, section.entry_begin); entry != end_of_list;
             entry = next_entry(next, entry, section.entry_begin))
            for (const Local& side : section.face_cell[section.face(entry - section.entry_begin)]) {
                const Index i = read_once(side);
                if (i >= section.count()) refuse_changed("a face refers to a cell that does not exist");
                scratch.to_solve[i / 64] |= std::uint64_t{1} << i % 64;
            }
}

template <class Local>
void Pass::add_polyhedra(const BlockSampler& sampler, Index b, const PolyhedralSection<Local>& section) {
    if (section.count() == 0) return;
    Scratch& scratch = gradient_scratch();
    const Block& block = blocks_.cells(b);
    mark_polyhedra(b, section, scratch);
    const Index place = block.cell_count - section.count();
    sampler.with([&](const auto& sample) {
        with_fits(field_.shared_fits(mesh_), b, block, section, sample, scratch.fitter, [&](auto&& fitted_at) {
            for (std::size_t word = 0; word < scratch.to_solve.size(); ++word)
                for (std::uint64_t bits = scratch.to_solve[word]; bits != 0; bits &= bits - 1) {
                    const auto i = static_cast<Index>(64 * word) + static_cast<Index>(std::countr_zero(bits));
                    const auto fitted = fitted_at(i);
                    const CellGradient cell = fitted_gradient(fitted, sample, scratch.stretched);
                    scratch.solved.add(place + i, cell);
                    GradientSum weighted;
                    weighted.add(cell);
                    for (const Index v : fitted.vertices) scratch.sum[scratch.slot[v]].add(weighted);
                }
        });
    });
}

void Pass::sum_at_border(Index b) {
    if (busy_[b] == 0) return;
    const Block& block = blocks_.cells(b);
    Scratch& scratch = gradient_scratch();
    const std::span<const std::uint8_t> state = states(block);
    blocks_.around(b).with([&](const auto& arrays) {
        for (Index place = 0; place < arrays.border_vertex.size(); ++place) {
            const Index v = std::min<Index>(read_once(arrays.border_vertex[place]), block.vertex_count - 1);
            if ((state[v] & wanted) == 0) continue;
            list_ring(blocks_, {b, place}, scratch.ring);
            const auto is_wanted = [this](const BlockVertex& at) {
                return (states(blocks_.cells(at.block))[at.vertex] & wanted) != 0;
            };
            const auto first = std::ranges::find_if(scratch.ring, is_wanted);
            if (first == scratch.ring.end() || first->block != b) continue; // another block sums this gradient
            AddStored add([this](Index other, Index cell) { return solved_[other].of(cell); });
            for_cells_around(blocks_, scratch.ring, scratch.cells, add);
            for (const BlockVertex at : scratch.ring)
                if (is_wanted(at)) set_gradient(at, add.sum.mean());
        }
    });
}

void Pass::settle(Index b) {
    for (std::uint8_t& state : states(blocks_.cells(b)))
        state = static_cast<std::uint8_t>((state & (wanted | known)) != 0 ? known : 0);
}

} // namespace

void GradientCache::make_at(const FaceMeshView& mesh, const Field::Data& field, std::span<const Index> blocks,
                            const BlockCuts& cut) {
    if (blocks.empty()) return;
    const Locked lock(mutex_);
    const Topology::Blocks& all = field.topology->blocks();
    if (state_.size() == 0) state_ = SparseArray<std::uint8_t>(all.slot_count());
    vertex_.resize(all.count());
    busy_.assign(vertex_.size(), 0);
    if (!settled_)
        for (std::uint8_t& state : state_.all()) state &= known;
    settled_ = false;
    Pass(mesh, field, state_.all(), busy_, vertex_).run(blocks, cut);
    settled_ = true;
}

void GradientCache::forget() {
    const Locked lock(mutex_);
    state_ = {};
    vertex_.clear();
    settled_ = true;
}

std::size_t GradientCache::memory_bytes() const {
    const Locked lock(mutex_);
    std::size_t made = 0;
    for (const auto& block : vertex_) made += block != nullptr ? 1 : 0;
    const std::size_t mean_slots = state_.size() / std::max<std::size_t>(1, vertex_.size());
    return made * mean_slots * (sizeof(std::uint8_t) + sizeof(Vec3f));
}

} // namespace ciel::detail
