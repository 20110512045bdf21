// Computes the gradients at all vertices, for volumes.
#include "ciel/parallel.hpp"
#include "fields/field_data.hpp"
#include "fields/gradient.hpp"
#include "fields/gradient_sums.hpp"
#include "fields/polyhedron_gradient.hpp"

namespace ciel::detail {

namespace {

constexpr std::size_t blocks_per_task = 2;

class Everywhere {
public:
    Everywhere(const FaceMeshView& mesh, const Field::Data& field)
        : mesh_(mesh), field_(field), blocks_(field.topology->blocks()),
          cell_(std::make_unique_for_overwrite<CellGradient[]>(blocks_.counts.cells)), out_(mesh.vertex_count()) {}

    std::vector<Vec3f> run() {
        for_blocks([this](Index b) { sum_inside(b); });
        for_blocks([this](Index b) { sum_at_border(b); });
        return std::move(out_);
    }

private:
    template <class F>
    void for_blocks(F&& body) {
        parallel_for(blocks_.count(), blocks_per_task, [&](std::size_t begin, std::size_t end) {
            for (std::size_t b = begin; b < end; ++b) body(static_cast<Index>(b));
        });
    }
    void sum_inside(Index b);
    void sum_at_border(Index b);

    const FaceMeshView& mesh_;
    const Field::Data& field_;
    const Topology::Blocks& blocks_;
    std::unique_ptr<CellGradient[]> cell_; // gradients of all cells, block by block, section by section
    std::vector<Vec3f> out_;
};

void Everywhere::sum_inside(Index b) {
    const Block& block = blocks_.cells(b);
    std::vector<Sample> samples, scratch;
    BlockSampler(mesh_, b, block, field_.of_block(b)).all(samples);
    const auto sample = [&](Index v) { return samples[v]; };
    std::vector<GradientSum> sum(block.vertex_count);
    CellGradient* cell = &cell_[block.cell_begin];
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
}

void Everywhere::sum_at_border(Index b) {
    const Block& block = blocks_.cells(b);
    std::vector<BlockVertex> ring;
    std::vector<Index> scratch;
    blocks_.around(b).with([&](const auto& arrays) {
        const auto first_own = std::ranges::lower_bound(arrays.border_vertex, block.ghost_vertex.size());
        for (auto v = first_own; v != arrays.border_vertex.end(); ++v) {
            list_ring(blocks_, {b, static_cast<Index>(v - arrays.border_vertex.begin())}, ring);
            AddStored add([this](Index other, Index place) { return &cell_[blocks_.numbers.cell[other] + place]; });
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
