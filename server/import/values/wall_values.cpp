#include "import/values/wall_values.hpp"

#include "ciel/linear_weights.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_map>

namespace server::importer {

namespace {

enum Kind : std::uint8_t { wall_at_rest, fixed, varying, untouched };

bool holds_one_value(ciel::ValuesView values, std::size_t width) {
    for (std::size_t i = width; i < values.size(); ++i)
        if (values[i] != values[i - width]) return false;
    return true;
}

// overlay() ignores values that are not finite, because the solution has diverged on these faces.
bool is_finite(ciel::ValuesView values, std::size_t begin, std::size_t width) {
    for (std::size_t i = begin; i < begin + width; ++i)
        if (!std::isfinite(values[i])) return false;
    return true;
}

} // namespace

bool holds_only_zero(ciel::ValuesView values) {
    return !values.empty() && std::ranges::all_of(values, [](double value) { return value == 0; });
}

WallValues::WallValues(const ciel::FaceMeshView& mesh, const std::vector<Patch>& patches)
    : entries_(patches.size()), planes_(patches.size()) {
    std::unordered_map<ciel::Index, ciel::Index> local;
    std::unordered_map<ciel::Index, double> area;
    for (std::size_t patch = 0; patch < patches.size(); ++patch) {
        PatchWeights weights = weigh_patch(mesh, patches[patch].faces);
        area.clear();
        for (PatchVertex& vertex : weights.vertices) {
            const auto [at, is_new] = local.try_emplace(vertex.vertex, static_cast<ciel::Index>(vertices_.size()));
            if (is_new) vertices_.push_back(vertex.vertex);
            area[vertex.vertex] = vertex.area;
            planes_[patch].push_back({at->second, std::move(vertex.normals)});
        }
        for (const PatchWeight& weight : weights.weights)
            entries_[patch].push_back(
                {local.at(weight.vertex), patches[patch].cells[weight.face], weight.weight * area.at(weight.vertex)});
    }
}

template <class T>
void WallValues::overlay(const std::vector<PatchValues>& values, const std::vector<PatchRole>& roles, int components,
                         std::span<T> points) const {
    const auto width = static_cast<std::size_t>(components);
    std::vector<std::uint8_t> kinds(vertices_.size(), untouched);
    std::vector<double> total(vertices_.size());
    std::vector<double> sum(vertices_.size() * width);
    for (std::size_t patch = 0; patch < entries_.size(); ++patch) {
        if (!values[patch]) continue;
        const ciel::ValuesView own = *values[patch];
        Kind kind = varying;
        if (roles[patch] == PatchRole::no_slip_wall)
            kind = wall_at_rest;
        else if (roles[patch] == PatchRole::other && holds_one_value(own, width))
            kind = fixed;
        for (const Entry& entry : entries_[patch]) {
            if (kind > kinds[entry.vertex] || (entry.cell + 1) * width > own.size()) continue;
            if (!is_finite(own, entry.cell * width, width)) continue;
            if (kind < kinds[entry.vertex]) {
                kinds[entry.vertex] = kind;
                total[entry.vertex] = 0;
                std::fill_n(sum.begin() + static_cast<std::ptrdiff_t>(entry.vertex * width), width, 0.0);
            }
            total[entry.vertex] += entry.weight;
            for (std::size_t c = 0; c < width; ++c)
                sum[entry.vertex * width + c] += entry.weight * own[entry.cell * width + c];
        }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        if (kinds[i] != untouched && total[i] > 0)
            for (std::size_t c = 0; c < width; ++c)
                points[vertices_[i] * width + c] = static_cast<T>(sum[i * width + c] / total[i]);
    if (components == 3) put_into_planes(roles, kinds, points);
}

// Makes vectors on planes tangential. Vertices of no-slip walls and of patches with a fixed value keep their vectors.
template <class T>
void WallValues::put_into_planes(const std::vector<PatchRole>& roles, const std::vector<std::uint8_t>& kinds,
                                 std::span<T> points) const {
    for (std::size_t patch = 0; patch < planes_.size(); ++patch) {
        if (roles[patch] != PatchRole::plane) continue;
        for (const WallPlane& plane : planes_[patch]) {
            if (kinds[plane.vertex] == wall_at_rest || kinds[plane.vertex] == fixed) continue;
            T* const at = &points[3 * std::size_t{vertices_[plane.vertex]}];
            const ciel::Vec3d along = ciel::without_parts_along(plane.normals, {at[0], at[1], at[2]});
            for (std::size_t axis = 0; axis < 3; ++axis) at[axis] = static_cast<T>(along[axis]);
        }
    }
}

template void WallValues::overlay(const std::vector<PatchValues>&, const std::vector<PatchRole>&, int,
                                  std::span<float>) const;
template void WallValues::overlay(const std::vector<PatchValues>&, const std::vector<PatchRole>&, int,
                                  std::span<double>) const;

} // namespace server::importer
