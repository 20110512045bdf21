#include "import/wall_values.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace ciel::importer {

namespace {

double area_of(const FaceMeshView& mesh, Index face) {
    const auto loop = mesh.loop(face);
    const auto at = [&](std::size_t i, std::size_t axis) {
        return static_cast<double>(mesh.positions[3 * std::size_t{loop[i]} + axis]) -
               static_cast<double>(mesh.positions[3 * std::size_t{loop[0]} + axis]);
    };
    Vec3d normal{};
    for (std::size_t i = 1; i + 1 < loop.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const std::size_t u = (axis + 1) % 3;
            const std::size_t v = (axis + 2) % 3;
            normal[axis] += at(i, u) * at(i + 1, v) - at(i, v) * at(i + 1, u);
        }
    return std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]) / 2;
}

bool holds_one_value(const std::vector<float>& values, std::size_t width) {
    for (std::size_t i = width; i < values.size(); ++i)
        if (values[i] != values[i - width]) return false;
    return true;
}

} // namespace

bool holds_only_zero(const std::vector<float>& values) {
    return !values.empty() && std::all_of(values.begin(), values.end(), [](float value) { return value == 0; });
}

WallValues::WallValues(const FaceMeshView& mesh, const std::vector<Patch>& patches) : entries_(patches.size()) {
    std::unordered_map<Index, Index> local;
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
        for (std::size_t i = 0; i < patches[patch].faces.size(); ++i) {
            const Index face = patches[patch].faces[i];
            // A face without area still has a say where there is no other.
            const double area = std::max(area_of(mesh, face), std::numeric_limits<double>::min());
            for (const Index vertex : mesh.loop(face)) {
                const auto [at, is_new] = local.try_emplace(vertex, static_cast<Index>(vertices_.size()));
                if (is_new) vertices_.push_back(vertex);
                entries_[patch].push_back({at->second, patches[patch].cells[i], area});
            }
        }
}

void WallValues::overlay(const std::vector<PatchValues>& values, const std::vector<bool>& no_slip, int components,
                         std::span<float> points) const {
    enum Kind : std::uint8_t { no_slip_wall, fixed, other, untouched };
    const auto width = static_cast<std::size_t>(components);
    std::vector<std::uint8_t> kinds(vertices_.size(), untouched);
    std::vector<double> area(vertices_.size());
    std::vector<double> sum(vertices_.size() * width);
    for (std::size_t patch = 0; patch < entries_.size(); ++patch) {
        if (!values[patch]) continue;
        const std::vector<float>& own = *values[patch];
        const Kind kind = no_slip[patch] ? no_slip_wall : holds_one_value(own, width) ? fixed : other;
        for (const Entry& entry : entries_[patch]) {
            if (kind > kinds[entry.vertex] || (entry.cell + 1) * width > own.size()) continue;
            if (kind < kinds[entry.vertex]) {
                kinds[entry.vertex] = kind;
                area[entry.vertex] = 0;
                std::fill_n(sum.begin() + static_cast<std::ptrdiff_t>(entry.vertex * width), width, 0.0);
            }
            area[entry.vertex] += entry.area;
            for (std::size_t c = 0; c < width; ++c)
                sum[entry.vertex * width + c] += entry.area * static_cast<double>(own[entry.cell * width + c]);
        }
    }
    for (std::size_t i = 0; i < vertices_.size(); ++i)
        if (kinds[i] != untouched)
            for (std::size_t c = 0; c < width; ++c)
                points[vertices_[i] * width + c] = static_cast<float>(sum[i * width + c] / area[i]);
}

} // namespace ciel::importer
