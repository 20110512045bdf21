#include "wire/joined_surface.hpp"

#include <algorithm>

namespace ciel::wire {
namespace {

template <typename T>
void append(std::vector<T>& to, const std::vector<T>& more) {
    to.insert(to.end(), more.begin(), more.end());
}

const NamedValues* find(const std::vector<NamedValues>& values, const std::string& name) {
    const auto found = std::find_if(values.begin(), values.end(), [&](const auto& one) { return one.name == name; });
    return found != values.end() ? &*found : nullptr;
}

} // namespace

void JoinedSurface::add(const Surface& surface, const std::vector<NamedValues>& values) {
    const auto first_vertex = static_cast<Index>(surface_.positions.size());
    const auto first_corner = static_cast<Index>(surface_.polygon_vertex.size());
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
    append(surface_.points, surface.points);
    append(surface_.polygon_cell, surface.polygon_cell);
    for (const Index vertex : surface.polygon_vertex) surface_.polygon_vertex.push_back(first_vertex + vertex);
    for (std::size_t i = 1; i < surface.polygon_offset.size(); ++i)
        surface_.polygon_offset.push_back(first_corner + surface.polygon_offset[i]);
    is_first_ = false;
}

} // namespace ciel::wire
