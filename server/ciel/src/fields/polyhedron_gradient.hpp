// The gradient in a polyhedron (paper, section 3), and its distinct vertices. One solver per thread is reused for many
// blocks.
#pragma once

#include "blocks/blocks.hpp"
#include "fields/gradient_sums.hpp"

namespace ciel {

class PolyhedronSolver {
public:
    // Call before solving cells of another block or with other values. Until the next `begin`, solve calls
    // `sample(local vertex)` at most once per vertex, and a cell may be solved once. A record that changes meanwhile
    // may name any vertex and face, which are limited to those of the block, or more corners, which throws Error.
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

    template <class Local, class Sampler>
    [[nodiscard]] CellGradient solve(const PolyhedralSection<Local>& section, Index cell, const Sampler& sample) {
        ++stamp_;
        vertices_.clear();
        samples_.clear();
        for (const Index ref : section.faces_of(cell)) {
            const auto loop = section.loop(ref / 2);
            spend(loop.size());
            for (Index k = loop.begin; k < loop.end; ++k) see(limited(section.vertex[k]), sample);
        }
        if (samples_.size() < 4) return {};
        const LeastSquares fit = least_squares(samples_);
        if (!fit.good) return {};
        return {fit.gradient, volume(section, cell, fit.mean)};
    }
    // Distinct local vertices of the cell solved last.
    [[nodiscard]] std::span<const Index> vertices() const { return vertices_; }

private:
    struct Vertex {
        Sample sample;
        Index stamp = 0; // stamp of the last cell with this vertex; below first_stamp_, `sample` is stale
    };

    static constexpr unsigned visits = 2; // how often the corners of a cell are visited at most

    void spend(Index corners) {
        if (corners > left_) [[unlikely]]
            refuse_changed("its cells have more corners than before");
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
        if (vertex.stamp < first_stamp_) vertex.sample = sample(v);
        vertex.stamp = stamp_;
        vertices_.push_back(v);
        samples_.push_back(vertex.sample);
    }

    // Returns the volume: the sum of the cones from `mean` to each face. A face's area vector is computed once for both
    // of its cells.
    template <class Local>
    [[nodiscard]] double volume(const PolyhedralSection<Local>& section, Index cell, const Sample& mean) {
        double six_volumes = 0;
        const Index last_face = section.face_count() - 1;
        for (const Index ref : section.faces_of(cell)) {
            const Index face = std::min(ref / 2, last_face);
            const Sample& apex = at(section, section.face_begin[face]);
            if (area_known_[face] == 0) {
                area_[face] = area(section, face, apex);
                area_known_[face] = 1;
            }
            const double cones = dot(arm(mean, apex), area_[face]);
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
    std::vector<Vec3d> area_;    // by face: twice the area vector, along the stored loop
    std::vector<std::uint8_t> area_known_;
    std::vector<Index> vertices_;
    std::vector<Sample> samples_;
    Index stamp_ = 0, first_stamp_ = 0;
    Index last_vertex_ = 0;
    std::uint64_t left_ = 0; // corners
};

} // namespace ciel
