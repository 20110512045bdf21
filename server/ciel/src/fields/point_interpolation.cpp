#include "ciel/point_interpolation.hpp"

#include "blocks/blocks.hpp"
#include "blocks/cell_loops.hpp"
#include "ciel/cell_shapes.hpp"
#include "ciel/linear_weights.hpp"
#include "ciel/mesh_faces.hpp"
#include "ciel/parallel.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace ciel {

struct PointInterpolation::CellAtVertex {
    Index vertex, cell;
    friend bool operator==(const CellAtVertex& a, const CellAtVertex& b) {
        return a.vertex == b.vertex && a.cell == b.cell;
    }
};

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

PointInterpolation::PointInterpolation(const Topology& topology, const FaceMeshView& mesh) {
    std::vector<Vec3d> centers = cell_centers(topology, mesh);
    const std::vector<CellAtVertex> collapsed = at_collapsed_faces(topology, mesh);
    for (const CellAtVertex& at : collapsed)
        if (topology.half_edge_begin(at.cell) == no_half_edge) centers[at.cell] = position(mesh, at.vertex);
    find_cells(topology, collapsed);
    weight_.assign(cell_.size(), 0.0F);
    const BoundaryNormals normals(mesh);
    parallel_for(mesh.vertex_count(), grain, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3d> displacements;
        std::vector<double> weights;
        for (std::size_t vertex = begin; vertex < end; ++vertex) {
            const std::span<const Index> cells(cell_.data() + offset_[vertex], offset_[vertex + 1] - offset_[vertex]);
            const Vec3d at = position(mesh, static_cast<Index>(vertex));
            displacements.clear();
            for (const Index cell : cells) displacements.push_back(centers[cell] - at);
            weights.resize(cells.size());
            linear_weights(displacements, normals.at(vertex), weights);
            for (std::size_t i = 0; i < weights.size(); ++i)
                weight_[offset_[vertex] + i] = static_cast<float>(weights[i]);
        }
    });
}

// Returns the cells that have a vertex only in a face that collapsed to a point. Blocks do not store such faces.
std::vector<PointInterpolation::CellAtVertex> PointInterpolation::at_collapsed_faces(const Topology& topology,
                                                                                     const FaceMeshView& mesh) {
    std::vector<CellAtVertex> found;
    std::vector<Index> loop;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const FaceCells beside = read_cells(mesh, face);
        if (beside.neighbour != none) continue;
        read_loop(mesh, face, loop);
        if (loop.empty() || std::ranges::any_of(loop, [&](Index v) { return v != loop[0]; })) continue;
        const std::vector<Index> corners = corners_of_cell(topology, beside.owner);
        if (!std::ranges::binary_search(corners, loop[0])) found.push_back({loop[0], beside.owner});
    }
    std::ranges::sort(found, {}, [](const CellAtVertex& at) { return std::pair(at.vertex, at.cell); });
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// Threads add the cells of a vertex in any order, so that the lists are sorted afterwards.
void PointInterpolation::find_cells(const Topology& topology, std::span<const CellAtVertex> further) {
    const std::size_t vertices = topology.counts().vertices;
    const Topology::Blocks& blocks = topology.blocks();
    const auto for_each_pair = [&](auto&& visit) {
        parallel_for(blocks.count(), 1, [&](std::size_t first, std::size_t last) {
            std::vector<Index> seen;
            for (auto b = static_cast<Index>(first); b < last; ++b)
                detail::for_corners_of_cells(blocks.cells(b), seen, visit);
        });
        for (const CellAtVertex& at : further) visit(at.cell, at.vertex);
    };
    offset_.assign(vertices + 1, 0);
    for_each_pair([&](Index, Index vertex) {
        std::atomic_ref(offset_[std::size_t{vertex} + 1]).fetch_add(1, std::memory_order_relaxed);
    });
    for (std::size_t i = 0; i < vertices; ++i) offset_[i + 1] += offset_[i];
    cell_.resize(offset_.back());
    std::vector<std::uint64_t> next(offset_.begin(), offset_.end() - 1);
    for_each_pair([&](Index cell, Index vertex) {
        const std::uint64_t at = std::atomic_ref(next[vertex]).fetch_add(1, std::memory_order_relaxed);
        if (at >= offset_[std::size_t{vertex} + 1]) fail("the mesh changed while it was read; restore its files");
        cell_[at] = cell;
    });
    parallel_for(vertices, grain, [&](std::size_t first, std::size_t last) {
        for (std::size_t vertex = first; vertex < last; ++vertex)
            std::sort(cell_.begin() + static_cast<std::ptrdiff_t>(offset_[vertex]),
                      cell_.begin() + static_cast<std::ptrdiff_t>(offset_[vertex + 1]));
    });
}

template <class T>
void PointInterpolation::apply_into(std::span<const T> cell_values, int components, std::span<T> points) const {
    const std::size_t vertices = offset_.size() - 1;
    const auto width = static_cast<std::size_t>(components);
    if (points.size() != vertices * width) fail("the point values need one tuple for each vertex");
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
                points[vertex * width + c] =
                    total > 0 ? static_cast<T>(sum / total) : std::numeric_limits<T>::quiet_NaN();
            }
    });
}

template void PointInterpolation::apply_into(std::span<const float>, int, std::span<float>) const;
template void PointInterpolation::apply_into(std::span<const double>, int, std::span<double>) const;

std::vector<float> PointInterpolation::apply(std::span<const float> cell_values, int components) const {
    std::vector<float> points((offset_.size() - 1) * static_cast<std::size_t>(components));
    apply_into(cell_values, components, std::span(points));
    return points;
}

std::vector<double> PointInterpolation::apply(std::span<const double> cell_values, int components) const {
    std::vector<double> points((offset_.size() - 1) * static_cast<std::size_t>(components));
    apply_into(cell_values, components, std::span(points));
    return points;
}

} // namespace ciel
