// The gradient in a polyhedron (paper, section 3). A PolyhedronFit depends only on positions, and serves all fields.
#pragma once

#include "blocks/blocks.hpp"
#include "fields/gradient_sums.hpp"

namespace ciel::detail {

// The least-squares data for the distinct vertices of a polyhedron. The size is one cache line (64 bytes).
struct PolyhedronFit {
    NormalEquations equations;
    double volume; // length cubed; 0 if the cell has no gradient
};

template <class Local>
struct FittedPolyhedron {
    const PolyhedronFit& fit;
    std::span<const Local> vertices; // the distinct local vertices of the cell
};

// `sample`: a BlockSampler::Typed. `scratch`: a buffer for stretched cells.
template <class Local, class Sampler>
[[nodiscard]] CellGradient fitted_gradient(const FittedPolyhedron<Local>& polyhedron, const Sampler& sample,
                                           std::vector<Sample>& scratch) {
    const auto& [fit, vertices] = polyhedron;
    if (!(fit.volume > 0)) return {};
    if (fit.equations.inverse_determinant == 0) {
        scratch.clear();
        for (const auto v : vertices) scratch.push_back(sample(v));
        const LeastSquares stretched = least_squares(scratch);
        if (!stretched.good) return {};
        return {stretched.gradient, fit.volume};
    }
    // Uses differences from the first sample, because values may vary by less than 1e-8 of their size.
    const Four first = load(sample(vertices[0]));
    Four sum{}, slopes{};
    for (const auto v : vertices) {
        const Four d = load(sample(v)) - first;
        sum += d;
        slopes += d * last_repeated(d);
    }
    if (!std::isfinite(sum[3])) return {};
    slopes -= sum * (sum[3] / static_cast<double>(vertices.size()));
    return {fit.equations.gradient(slopes), fit.volume};
}

// Makes the fits of polyhedra. Can be reused for many blocks; each thread needs its own object.
class PolyhedronFitter {
public:
    // Call it before fitting cells of another block, and when the positions have changed. Each cell may be fitted once
    // until the next `begin`. If the record changes, `fit` throws Error when cells have too many corners.
    template <class Local>
    void begin(const Block& block, const PolyhedralSection<Local>& section) {
        if (vertex_.size() < block.vertex_count) vertex_.resize(block.vertex_count);
        area_known_.assign(section.face_count(), 0);
        if (area_.size() < section.face_count()) area_.resize(section.face_count());
        last_vertex_ = block.vertex_count - 1;
        left_ = std::uint64_t{visits} * section.half_edge_count();
        if (stamp_ > none - block.cell_count - 2) forget_stamps();
        first_stamp_ = ++stamp_;
    }

    // Returns the fit of a cell, which is valid until the next call. Calls `sample` at most once per vertex, and uses
    // only positions.
    template <class Local, class Sampler>
    [[nodiscard]] FittedPolyhedron<Index> fit(const PolyhedralSection<Local>& section, Index cell,
                                              const Sampler& sample) {
        ++stamp_;
        vertices_.clear();
        samples_.clear();
        for (const Index ref : section.faces_of(cell)) {
            const auto loop = section.loop(ref / 2);
            spend(loop.size());
            for (Index k = loop.begin; k < loop.end; ++k) see(limited(section.vertex[k]), sample);
        }
        const Moments moments = centered(samples_);
        fit_ = {NormalEquations(moments), samples_.size() < 4 ? 0 : volume(section, cell, moments.mean)};
        return {fit_, vertices_};
    }

private:
    struct Vertex {
        Sample sample;
        Index stamp = 0; // number of the last fit with this vertex; if < first_stamp_, `sample` is out of date
    };

    static constexpr unsigned visits = 2; // maximum number of visits to each half-edge of the section

    void spend(Index corners) {
        if (corners > left_) [[unlikely]]
            refuse_changed("the cells of the block have more corners than before");
        left_ -= corners;
    }
    [[nodiscard]] Index limited(Index v) const { return std::min(v, last_vertex_); }
    template <class Local>
    [[nodiscard]] const Sample& at(const PolyhedralSection<Local>& section, Index corner) const {
        return vertex_[limited(section.vertex[corner])].sample;
    }

    template <class Sampler>
    void see(Index v, const Sampler& sample) {
        Vertex& vertex = vertex_[v];
        if (vertex.stamp == stamp_) return;
        if (vertex.stamp < first_stamp_) {
            vertex.sample = sample(v);
            vertex.sample.value = 0;
        }
        vertex.stamp = stamp_;
        vertices_.push_back(v);
        samples_.push_back(vertex.sample);
    }

    // Sums the volumes of the pyramids from `mean` to each face. Both cells of a face use the same area vector.
    template <class Local>
    [[nodiscard]] double volume(const PolyhedralSection<Local>& section, Index cell, const Four& mean) {
        double six_volumes = 0;
        const Index last_face = section.face_count() - 1;
        const Sample from{mean[0], mean[1], mean[2], 0};
        for (const Index ref : section.faces_of(cell)) {
            const Index face = std::min(ref / 2, last_face);
            const Sample& apex = at(section, section.face_begin[face]);
            if (area_known_[face] == 0) {
                area_[face] = area(section, face, apex);
                area_known_[face] = 1;
            }
            const double cones = dot(arm(from, apex), area_[face]);
            six_volumes += ref % 2 == 0 ? cones : -cones;
        }
        return std::abs(six_volumes) / 6;
    }

    template <class Local>
    [[nodiscard]] Vec3d area(const PolyhedralSection<Local>& section, Index face, const Sample& apex) {
        Vec3d sum{};
        const auto loop = section.loop(face);
        spend(loop.size());
        Vec3d before = arm(apex, at(section, loop.begin + 1));
        for (Index k = loop.begin + 2; k < loop.end; ++k) {
            const Vec3d here = arm(apex, at(section, k));
            const Vec3d part = cross(before, here);
            for (std::size_t axis = 0; axis < 3; ++axis) sum[axis] += part[axis];
            before = here;
        }
        return sum;
    }

    void forget_stamps() {
        for (Vertex& vertex : vertex_) vertex.stamp = 0;
        stamp_ = 0;
    }

    std::vector<Vertex> vertex_; // by local vertex
    std::vector<Vec3d> area_;    // by face: twice the area vector of the stored loop
    std::vector<std::uint8_t> area_known_;
    std::vector<Index> vertices_;
    std::vector<Sample> samples_;
    PolyhedronFit fit_{};
    Index stamp_ = 0, first_stamp_ = 0;
    Index last_vertex_ = 0;
    std::uint64_t left_ = 0; // corners that may still be visited
};

} // namespace ciel::detail
