#include "ciel/point_interpolation.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/linear_weights.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ciel {

namespace {

constexpr std::size_t grain = 4096;

class BoundaryNormals {
public:
    explicit BoundaryNormals(const FaceMeshView& mesh) : at_(mesh.vertex_count(), none) {
        std::vector<Index> loop;
        for (Index face = 0; face < mesh.face_count(); ++face) {
            if (read_cells(mesh, face).neighbour != none) continue;
            read_loop(mesh, face, loop);
            const Vec3d area = face_shape(mesh, loop).area;
            for (const Index vertex : loop) {
                if (at_[vertex] == none) {
                    at_[vertex] = static_cast<Index>(normals_.size());
                    normals_.emplace_back();
                }
                normals_[at_[vertex]].add(area);
            }
        }
    }
    [[nodiscard]] std::vector<Vec3d> at(std::size_t vertex) const {
        return at_[vertex] == none ? std::vector<Vec3d>{} : normals_[at_[vertex]].directions();
    }

private:
    std::vector<Index> at_;
    std::vector<LeftOutDirections> normals_;
};

} // namespace

PointInterpolation::PointInterpolation(const FaceMeshView& mesh) {
    find_cells(mesh);
    weight_.assign(cell_.size(), 0.0F);
    const std::vector<Vec3d> centres = cell_centres(mesh);
    const BoundaryNormals normals(mesh);
    parallel_for(mesh.vertex_count(), grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3d> displacements;
        std::vector<double> weights;
        for (std::size_t vertex = begin; vertex < end; ++vertex) {
            const std::span<const Index> cells(cell_.data() + offset_[vertex], offset_[vertex + 1] - offset_[vertex]);
            const Vec3d at = position(mesh, static_cast<Index>(vertex));
            displacements.clear();
            for (const Index cell : cells) displacements.push_back(centres[cell] - at);
            weights.resize(cells.size());
            linear_weights(displacements, normals.at(vertex), weights);
            for (std::size_t i = 0; i < weights.size(); ++i)
                weight_[offset_[vertex] + i] = static_cast<float>(weights[i]);
        }
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

template <class T>
std::vector<T> PointInterpolation::apply_to(std::span<const T> cell_values, int components) const {
    const std::size_t vertices = offset_.size() - 1;
    const auto width = static_cast<std::size_t>(components);
    std::vector<T> values(vertices * width);
    parallel_for(vertices, grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t vertex = first; vertex < last; ++vertex)
            for (std::size_t c = 0; c < width; ++c) {
                double sum = 0;
                double total = 0;
                for (std::uint64_t i = offset_[vertex]; i < offset_[vertex + 1]; ++i) {
                    const T value = cell_values[cell_[i] * width + c];
                    if (!std::isfinite(value)) continue;
                    sum += static_cast<double>(weight_[i]) * value;
                    total += weight_[i];
                }
                values[vertex * width + c] =
                    total > 0 ? static_cast<T>(sum / total) : std::numeric_limits<T>::quiet_NaN();
            }
    });
    return values;
}

std::vector<float> PointInterpolation::apply(std::span<const float> cell_values, int components) const {
    return apply_to(cell_values, components);
}

std::vector<double> PointInterpolation::apply(std::span<const double> cell_values, int components) const {
    return apply_to(cell_values, components);
}

} // namespace ciel
