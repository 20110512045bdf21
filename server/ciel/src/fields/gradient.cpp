#include "fields/gradient.hpp"

#include "ciel/parallel.hpp"
#include "fields/field_data.hpp"
#include "fields/gradient_sums.hpp"
#include "fields/polyhedron_gradient.hpp"

#include <atomic>

namespace ciel {

namespace {

constexpr std::size_t blocks_per_task = 2;
// If a block wants at most this many gradients, the cells around each vertex are solved separately, without a pass over
// the block.
constexpr std::size_t few = 12;

enum State : std::uint8_t { wanted = 1, asked_by_neighbour = 2, known = 4 };

struct Scratch {
    std::vector<Sample> sample; // by local vertex
    std::vector<GradientSum> sum;
    std::vector<Index> wanted, cells;
    std::vector<BlockVertex> ring;
    std::vector<std::uint8_t> face_asked;
    PolyhedronSolver polyhedron;
};

Scratch& scratch_of_this_thread() {
    static thread_local Scratch scratch;
    return scratch;
}

// Visitor for for_cells_around that solves each visited cell and adds its gradient to `sum`.
struct AddSolved {
    const FaceMeshView& mesh;
    const Field::Data& field;
    Scratch& scratch;
    GradientSum sum;

    [[nodiscard]] BlockSampler sampler(Index b) const {
        return {mesh, field.topology->blocks().cells(b), field.of_block(b)};
    }
    template <const StandardShape& shape>
    void standard(Index b, const StandardSection& section, Index i, Index) {
        sum.add(cell_gradient<shape>(&section.vertex[i * shape.corners], sampler(b)));
    }
    void polyhedron(Index b, Index i, Index) {
        field.topology->blocks().cells(b).with([&](const auto& polyhedra) {
            scratch.polyhedron.begin(field.topology->blocks().cells(b), polyhedra);
            sum.add(scratch.polyhedron.solve(polyhedra, i, sampler(b)));
        });
    }
};

// One call of make_at. In a block with few wanted vertices, the cells around each vertex are solved separately.
// Otherwise the block, and the blocks that share its wanted vertices, solve each needed cell once. Then the gradients
// at vertices shared by blocks are summed.
class Pass {
public:
    Pass(const FaceMeshView& mesh, const Field::Data& field, std::span<std::uint8_t> state,
         std::span<std::uint8_t> busy, std::span<std::unique_ptr<Vec3f[]>> gradient)
        : mesh_(mesh), field_(field), blocks_(field.topology->blocks()), state_(state), busy_(busy),
          gradient_(gradient) {}

    void run(std::span<const Index> active, std::span<const ActiveBlock> cut) {
        for_each(active, [&](Index b) { want(b, cut[b]); });
        std::vector<Index> busy;
        for (Index b = 0; b < busy_.size(); ++b)
            if (busy_[b] != 0) busy.push_back(b);
        if (busy.empty()) return;
        cell_.resize(blocks_.count());
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
    [[nodiscard]] std::span<std::uint8_t> states(const Block& block) const {
        return state_.subspan(block.vertex_begin, block.vertex_count);
    }
    void mark_busy(Index b) { std::atomic_ref(busy_[b]).store(1, std::memory_order_relaxed); }

    void want(Index b, const ActiveBlock& cut);
    void solve_one_by_one(Index b, std::span<const Index> vertices);
    void ask_neighbours(Index b);
    void sum_inside(Index b);
    template <const StandardShape& shape>
    void add_standard(const Block& block, const StandardSection& section, CellGradient* cell);
    template <class Local>
    void add_polyhedra(const Block& block, const PolyhedralSection<Local>& section, CellGradient* cell);
    void sum_at_border(Index b);
    void settle(Index b);

    const FaceMeshView& mesh_;
    const Field::Data& field_;
    const Topology::Blocks& blocks_;
    std::span<std::uint8_t> state_;
    std::span<std::uint8_t> busy_; // by block: 1 if it has cells to solve
    std::span<std::unique_ptr<Vec3f[]>> gradient_;
    std::vector<std::unique_ptr<CellGradient[]>> cell_; // by block: gradients of its cells, section by section
};

void Pass::want(Index b, const ActiveBlock& cut) {
    const Block& block = blocks_.cells(b);
    if (gradient_[b] == nullptr) gradient_[b] = std::make_unique_for_overwrite<Vec3f[]>(block.vertex_count);
    const std::span<std::uint8_t> state = states(block);
    std::vector<Index>& found = scratch_of_this_thread().wanted;
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
    Scratch& scratch = scratch_of_this_thread();
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
            const Index v = blocks_.vertex_at({b, place});
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

void Pass::sum_inside(Index b) {
    const Block& block = blocks_.cells(b);
    Scratch& scratch = scratch_of_this_thread();
    BlockSampler(mesh_, block, field_.of_block(b)).all(scratch.sample);
    scratch.sum.assign(block.vertex_count, {});
    cell_[b] = std::make_unique_for_overwrite<CellGradient[]>(block.cell_count);
    const std::span<const std::uint8_t> state = states(block);
    CellGradient* cell = cell_[b].get();
    for (const StandardSection& section : block.standard) {
        with_shape(section.shape->type,
                   [&]<const StandardShape & shape>() { add_standard<shape>(block, section, cell); });
        cell += section.count();
    }
    block.with([&](const auto& polyhedra) {
        scratch.polyhedron.begin(block, polyhedra);
        add_polyhedra(block, polyhedra, cell);
    });
    for (Index v = 0; v < block.vertex_count; ++v)
        if ((state[v] & wanted) != 0) gradient_[b][v] = scratch.sum[v].mean();
}

template <const StandardShape& shape>
void Pass::add_standard(const Block& block, const StandardSection& section, CellGradient* cell) {
    Scratch& scratch = scratch_of_this_thread();
    const std::span<const std::uint8_t> state = states(block);
    for (std::size_t begin = 0; begin < section.vertex.size(); begin += shape.corners, ++cell) {
        const auto vertex = corners_of<shape>(block, &section.vertex[begin]);
        unsigned states = 0;
        for (std::size_t c = 0; c < shape.corners; ++c) states |= state[vertex[c]];
        if ((states & (wanted | asked_by_neighbour)) == 0) continue;
        *cell = cell_gradient<shape>(vertex.data(), [&](Index v) { return scratch.sample[v]; });
        GradientSum weighted;
        weighted.add(*cell);
        for (std::size_t c = 0; c < shape.corners; ++c) scratch.sum[vertex[c]].add(weighted);
    }
}

template <class Local>
void Pass::add_polyhedra(const Block& block, const PolyhedralSection<Local>& section, CellGradient* cell) {
    Scratch& scratch = scratch_of_this_thread();
    const std::span<const std::uint8_t> state = states(block);
    const Index last = block.vertex_count - 1;
    // Computes one flag per face first, because two cells read each face. A changed record may name any face and vertex
    // of 16 bits.
    scratch.face_asked.resize(std::max<std::size_t>(section.face_count(), local_ids / 2));
    for (Index face = 0, k = 0; face < section.face_count(); ++face) {
        unsigned states = 0;
        for (const Index end = read_once(section.face_begin[face + 1]); k < end; ++k)
            states |= state[std::min<Index>(section.vertex[k], last)];
        scratch.face_asked[face] = (states & (wanted | asked_by_neighbour)) != 0 ? 1 : 0;
    }
    for (Index i = 0; i < section.count(); ++i, ++cell) {
        if (std::ranges::none_of(section.faces_of(i), [&](Index ref) { return scratch.face_asked[ref / 2] != 0; }))
            continue;
        *cell = scratch.polyhedron.solve(section, i, [&](Index v) { return scratch.sample[v]; });
        GradientSum weighted;
        weighted.add(*cell);
        for (const Index v : scratch.polyhedron.vertices()) scratch.sum[v].add(weighted);
    }
}

void Pass::sum_at_border(Index b) {
    if (busy_[b] == 0) return;
    const Block& block = blocks_.cells(b);
    Scratch& scratch = scratch_of_this_thread();
    const std::span<const std::uint8_t> state = states(block);
    blocks_.around(b).with([&](const auto& arrays) {
        for (Index place = 0; place < arrays.border_vertex.size(); ++place) {
            const Index v = blocks_.vertex_at({b, place});
            if ((state[v] & wanted) == 0) continue;
            list_ring(blocks_, {b, place}, scratch.ring);
            AddStored add([this](Index other) { return cell_[other].get(); });
            for_cells_around(blocks_, scratch.ring, scratch.cells, add);
            gradient_[b][v] = add.sum.mean();
        }
    });
}

void Pass::settle(Index b) {
    for (std::uint8_t& state : states(blocks_.cells(b)))
        state = static_cast<std::uint8_t>((state & (wanted | known)) != 0 ? known : 0);
}

} // namespace

void GradientCache::make_at(const FaceMeshView& mesh, const Field::Data& field, std::span<const Index> blocks,
                            std::span<const ActiveBlock> cut) {
    if (blocks.empty()) return;
    const Locked lock(mutex_);
    const Topology::Blocks& all = field.topology->blocks();
    state_.resize(all.slot_count());
    vertex_.resize(all.count());
    busy_.assign(vertex_.size(), 0);
    if (!settled_)
        for (std::uint8_t& state : state_) state &= known;
    settled_ = false;
    Pass(mesh, field, state_, busy_, vertex_).run(blocks, cut);
    settled_ = true;
}

void GradientCache::forget() {
    const Locked lock(mutex_);
    state_.clear();
    vertex_.clear();
    settled_ = true;
}

std::size_t GradientCache::memory_bytes() const {
    const Locked lock(mutex_);
    std::size_t made = 0;
    for (const auto& block : vertex_) made += block != nullptr ? 1 : 0;
    const std::size_t mean_slots = state_.size() / std::max<std::size_t>(1, vertex_.size());
    return state_.capacity() + made * mean_slots * sizeof(Vec3f);
}

} // namespace ciel
