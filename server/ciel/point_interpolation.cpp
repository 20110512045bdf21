#include "ciel/point_interpolation.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr std::size_t grain = 4096;

// Solves the symmetric 3x3 system by Cramer's rule; false when it is too close to singular to be of use.
bool solve(const std::array<double, 6>& m, Vec3d right, Vec3d& x) {
    const Vec3d a{m[0], m[1], m[2]};
    const Vec3d b{m[1], m[3], m[4]};
    const Vec3d c{m[2], m[4], m[5]};
    const double determinant = dot(a, cross(b, c));
    const double scale = m[0] + m[3] + m[5];
    if (!(std::abs(determinant) > 1e-9 * scale * scale * scale)) return false;
    x = (1 / determinant) * Vec3d{dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))};
    return true;
}

} // namespace

PointInterpolation::PointInterpolation(const FaceMeshView& mesh) {
    find_cells(mesh);
    weight_.assign(cell_.size(), 0.0F);
    const std::vector<Vec3d> centres = cell_centres(mesh, face_shapes(mesh));
    parallel_for(mesh.vertex_count(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t vertex = begin; vertex < end; ++vertex) find_weights(mesh, centres, vertex);
    });
}

void PointInterpolation::find_cells(const FaceMeshView& mesh) {
    const std::size_t vertices = mesh.vertex_count();
    std::vector<Index> loop;
    const auto for_each_pair = [&](auto&& visit) {
        for (Index face = 0; face < mesh.face_count(); ++face) {
            read_loop(mesh, face, loop);
            const FaceCells beside = read_cells(mesh, face);
            for (const Index vertex : loop) {
                visit(vertex, beside.owner);
                if (beside.neighbour != none) visit(vertex, beside.neighbour);
            }
        }
    };
    std::vector<std::uint64_t> begin(vertices + 1, 0);
    for_each_pair([&](Index vertex, Index) { ++begin[vertex + 1]; });
    for (std::size_t i = 0; i < vertices; ++i) begin[i + 1] += begin[i];
    std::vector<Index> all(begin.back());
    std::vector<std::uint64_t> next(begin.begin(), begin.end() - 1);
    for_each_pair([&](Index vertex, Index cell) {
        if (next[vertex] == begin[vertex + 1]) fail("the mesh changed while it was read; restore its files");
        all[next[vertex]++] = cell;
    });

    offset_.assign(1, 0);
    for (std::size_t vertex = 0; vertex < vertices; ++vertex) {
        const auto first = all.begin() + static_cast<std::ptrdiff_t>(begin[vertex]);
        const auto last = all.begin() + static_cast<std::ptrdiff_t>(begin[vertex + 1]);
        std::sort(first, last);
        cell_.insert(cell_.end(), first, std::unique(first, last));
        offset_.push_back(cell_.size());
    }
}

void PointInterpolation::find_weights(const FaceMeshView& mesh, std::span<const Vec3d> centres, std::size_t vertex) {
    const std::uint64_t begin = offset_[vertex];
    const std::uint64_t end = offset_[vertex + 1];
    const Vec3d at = position(mesh, static_cast<Index>(vertex));
    Vec3d sum{};
    std::array<double, 6> moments{};
    for (std::uint64_t i = begin; i < end; ++i) {
        const Vec3d d = centres[cell_[i]] - at;
        sum = sum + d;
        moments[0] += d[0] * d[0];
        moments[1] += d[0] * d[1];
        moments[2] += d[0] * d[2];
        moments[3] += d[1] * d[1];
        moments[4] += d[1] * d[2];
        moments[5] += d[2] * d[2];
    }
    // Weights 1 + lambda . d with sum(weight * d) = 0, clipped to [0, 2] so that none is negative.
    Vec3d lambda{};
    const bool solved = solve(moments, -1.0 * sum, lambda);
    double total = 0;
    const auto weight = [&](std::uint64_t i) {
        const Vec3d d = centres[cell_[i]] - at;
        if (solved) return std::clamp(1 + dot(lambda, d), 0.0, 2.0);
        return 1 / (std::sqrt(dot(d, d)) + std::numeric_limits<float>::min());
    };
    for (std::uint64_t i = begin; i < end; ++i) total += weight(i);
    const bool usable = total > 0 && std::isfinite(total);
    for (std::uint64_t i = begin; i < end; ++i)
        weight_[i] = static_cast<float>(usable ? weight(i) / total : 1.0 / static_cast<double>(end - begin));
}

std::vector<float> PointInterpolation::apply(std::span<const float> cell_values, int components) const {
    const std::size_t vertices = offset_.size() - 1;
    const auto width = static_cast<std::size_t>(components);
    std::vector<float> values(vertices * width);
    parallel_for(vertices, grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t vertex = first; vertex < last; ++vertex)
            for (std::size_t c = 0; c < width; ++c) {
                double sum = 0;
                double total = 0;
                for (std::uint64_t i = offset_[vertex]; i < offset_[vertex + 1]; ++i) {
                    const float value = cell_values[cell_[i] * width + c];
                    if (!std::isfinite(value)) continue;
                    sum += static_cast<double>(weight_[i]) * value;
                    total += weight_[i];
                }
                values[vertex * width + c] =
                    total > 0 ? static_cast<float>(sum / total) : std::numeric_limits<float>::quiet_NaN();
            }
    });
    return values;
}

} // namespace ciel
