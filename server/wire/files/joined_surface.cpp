#include "wire/files/joined_surface.hpp"

#include <algorithm>
#include <bit>
#include <unordered_map>

namespace server::wire {
namespace {

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

const NamedValues* find(const std::vector<NamedValues>& values, const std::string& name) {
    const auto found = std::find_if(values.begin(), values.end(), [&](const auto& one) { return one.name == name; });
    return found != values.end() ? &*found : nullptr;
}

// A mesh vertex with exactly the iso-value has a surface vertex on each of its edges. Merging these vertices keeps the
// surface closed when polygons without area are left out. Vertices with different values are not merged.
std::vector<ciel::Index> one_vertex_per_place(const ciel::Surface& surface, const std::vector<NamedValues>& values) {
    std::vector<ciel::Index> kept(surface.positions.size());
    std::unordered_map<ciel::Index, ciel::Index> at_mesh_vertex;
    const auto have_equal_values = [&](ciel::Index a, ciel::Index b) {
        return std::ranges::all_of(values, [&](const NamedValues& named) {
            return std::bit_cast<std::uint64_t>(named.values[a]) == std::bit_cast<std::uint64_t>(named.values[b]);
        });
    };
    for (ciel::Index v = 0; v < kept.size(); ++v) {
        kept[v] = v;
        if (v >= surface.points.size()) continue;
        const ciel::EdgePoint& point = surface.points[v];
        const auto t = static_cast<float>(point.t); // rounded to float like the positions
        if (t != 0 && t != 1) continue;
        const ciel::Index first = at_mesh_vertex.try_emplace(t == 0 ? point.a : point.b, v).first->second;
        if (have_equal_values(first, v)) kept[v] = first;
    }
    return kept;
}

} // namespace

void JoinedSurface::add(const ciel::Surface& surface, const std::vector<NamedValues>& values,
                        std::span<const ciel::Vec3d> places) {
    const auto first_vertex = static_cast<ciel::Index>(surface_.positions.size());
    const auto first_corner = static_cast<ciel::Index>(surface_.polygon_vertex.size());
    const bool keeps_normals = is_first_ || !surface_.normals.empty() || surface_.positions.empty();
    if (keeps_normals && surface.normals.size() == surface.positions.size())
        append(surface_.normals, surface.normals);
    else if (!surface.positions.empty())
        surface_.normals.clear();
    if (is_first_)
        values_ = values;
    else {
        std::erase_if(values_, [&](const NamedValues& own) { return find(values, own.name) == nullptr; });
        for (NamedValues& own : values_) append(own.values, find(values, own.name)->values);
    }
    append(surface_.positions, surface.positions);
    places_.insert(places_.end(), places.begin(), places.end());
    append(surface_.points, surface.points);
    append(surface_.polygon_cell, surface.polygon_cell);
    const std::vector<ciel::Index> kept = one_vertex_per_place(surface, values);
    for (const ciel::Index vertex : surface.polygon_vertex)
        surface_.polygon_vertex.push_back(first_vertex + kept[vertex]);
    for (std::size_t i = 1; i < surface.polygon_offset.size(); ++i)
        surface_.polygon_offset.push_back(first_corner + surface.polygon_offset[i]);
    is_first_ = false;
}

} // namespace server::wire
