// Computes the gradients at all vertices, for volumes.
#include "ciel/parallel.hpp"
#include "ciel/threads.hpp"
#include "fields/field_data.hpp"
#include "fields/gradient.hpp"
#include "fields/gradient_sums.hpp"
#include "fields/polyhedron_gradient.hpp"

#include <atomic>

namespace ciel::detail {

namespace {

// Keeps the gradients of a block's cells until this block and all earlier blocks are done. The gradient at a border
// vertex is summed with the first block of its ring, so it needs no earlier block. Few blocks are kept at a time,
// because blocks that are near in the block order are near in space. Thread-safe.
class CellGradients {
public:
    using OfBlock = std::unique_ptr<CellGradient[]>; // section by section

    explicit CellGradients(std::size_t blocks) : is_done_(blocks) { made_.resize(blocks); }

    // Returns the gradients of block `of`. The first call for a block calls make(). `user`: the block that sums at a
    // border vertex. Returns null if `of` is earlier than `user`, because the gradients of `of` may already be dropped.
    template <class Make>
    [[nodiscard]] const CellGradient* get(Index of, Index user, Make&& make) {
        if (of < user) [[unlikely]]
            return nullptr;
        return made_.of(of, make).get();
    }
    void done(Index b) {
        const Locked lock(mutex_);
        is_done_[b] = 1;
        for (; first_ < is_done_.size() && is_done_[first_] != 0; ++first_) made_.drop(first_);
    }

private:
    Touched<OfBlock> made_;
    Mutex mutex_;
    std::vector<std::uint8_t> is_done_;
    std::size_t first_ = 0; // the first block that is not done
};

class Everywhere {
public:
    Everywhere(const FaceMeshView& mesh, const Field::Data& field)
        : mesh_(mesh), field_(field), blocks_(field.topology->blocks()), cells_(blocks_.count()),
          out_(mesh.vertex_count()) {}

    std::vector<Vec3f> run() {
        // Threads share a counter, because far apart ranges of parallel_for would keep the gradients of many blocks.
        std::atomic<Index> next{0};
        parallel_for(blocks_.count(), 1, [&](std::size_t begin, std::size_t end) {
            for (; begin < end; ++begin) {
                const Index b = next++;
                (void)cells_of(b, b);
                sum_at_border(b);
                cells_.done(b);
            }
        });
        return std::move(out_);
    }

private:
    [[nodiscard]] const CellGradient* cells_of(Index b, Index user) {
        return cells_.get(b, user, [&] { return sum_inside(b); });
    }
    // Sets the gradients at owned vertices; sum_at_border replaces those at the border. Returns the cells' gradients.
    [[nodiscard]] CellGradients::OfBlock sum_inside(Index b);
    void sum_at_border(Index b);

    const FaceMeshView& mesh_;
    const Field::Data& field_;
    const Topology::Blocks& blocks_;
    CellGradients cells_;
    std::vector<Vec3f> out_;
};

CellGradients::OfBlock Everywhere::sum_inside(Index b) {
    const Block& block = blocks_.cells(b);
    std::vector<Sample> samples, scratch;
    BlockSampler(mesh_, b, block, field_.of_block(b)).all(samples);
    const auto sample = [&](Index v) { return samples[v]; };
    std::vector<GradientSum> sum(block.vertex_count);
    auto gradients = std::make_unique_for_overwrite<CellGradient[]>(block.cell_count);
    CellGradient* cell = gradients.get();
    for (const StandardSection& section : block.standard)
        with_shape(section.shape->type, [&]<const StandardShape & shape>() {
            for (std::size_t begin = 0; begin < section.vertex.size(); begin += shape.corners, ++cell) {
                const auto vertex = corners_of<shape>(block, &section.vertex[begin]);
                *cell = cell_gradient<shape>(vertex.data(), sample);
                GradientSum weighted;
                weighted.add(*cell);
                for (const Index v : vertex) sum[v].add(weighted);
            }
        });
    PolyhedronFitter fitter;
    block.with([&](const auto& polyhedra) {
        fitter.begin(block, polyhedra);
        for (Index i = 0; i < polyhedra.count(); ++i, ++cell) {
            const FittedPolyhedron<Index> fitted = fitter.fit(polyhedra, i, sample);
            *cell = fitted_gradient(fitted, sample, scratch);
            GradientSum weighted;
            weighted.add(*cell);
            for (const Index v : fitted.vertices) sum[v].add(weighted);
        }
    });
    const auto ghosts = static_cast<Index>(block.ghost_vertex.size());
    for (Index v = ghosts; v < block.vertex_count; ++v) out_[block.vertex(v)] = sum[v].mean();
    return gradients;
}

void Everywhere::sum_at_border(Index b) {
    const Block& block = blocks_.cells(b);
    std::vector<BlockVertex> ring;
    std::vector<Index> scratch;
    blocks_.around(b).with([&](const auto& arrays) {
        const auto first_own = std::ranges::lower_bound(arrays.border_vertex, block.ghost_vertex.size());
        for (auto v = first_own; v != arrays.border_vertex.end(); ++v) {
            list_ring(blocks_, {b, static_cast<Index>(v - arrays.border_vertex.begin())}, ring);
            AddStored add([this, b](Index other, Index place) {
                const CellGradient* cells = cells_of(other, b);
                return cells == nullptr ? nullptr : cells + place;
            });
            for_cells_around(blocks_, ring, scratch, add);
            out_[block.vertex(*v)] = add.sum.mean();
        }
    });
}

} // namespace

std::vector<Vec3f> gradients_everywhere(const FaceMeshView& mesh, const Field::Data& field) {
    return Everywhere(mesh, field).run();
}

} // namespace ciel::detail

namespace ciel {

std::vector<Vec3f> vertex_gradients(const FaceMeshView& mesh, ValuesView values) {
    return vertex_gradients(Topology(mesh), mesh, values);
}

std::vector<Vec3f> vertex_gradients(const Topology& topology, const FaceMeshView& mesh, ValuesView values) {
    // The field is used in this call only, so that its values need no owner.
    const std::shared_ptr<const void> for_this_call(std::shared_ptr<const void>(), &topology);
    const Field field(topology, values, for_this_call);
    return detail::gradients_everywhere(mesh, field.data());
}

} // namespace ciel
