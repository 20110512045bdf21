#include "import/mesh/corner_index.hpp"

#include "ciel/cell_geometry.hpp"

#include <algorithm>
#include <bit>

namespace server::importer {

namespace {

template <typename Words>
std::size_t mix(const Words& words) {
    std::uint64_t hash = 0x9E3779B97F4A7C15U;
    for (const std::uint64_t word : words) {
        hash = (hash ^ word) * 0xBF58476D1CE4E5B9U;
        hash ^= hash >> 29;
    }
    return hash;
}

} // namespace

Corners normalised(Corners corners) {
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::size_t CornersHash::operator()(const Corners& corners) const { return mix(corners); }
std::size_t CornerIndex::PlaceHash::operator()(const Place& place) const { return mix(place); }

CornerIndex::Place CornerIndex::place_of(const ciel::Vec3d& position) {
    Place place{};
    // Adding 0 turns -0 into +0, so that equal positions have equal bits.
    for (std::size_t axis = 0; axis < 3; ++axis) place[axis] = std::bit_cast<std::uint64_t>(position[axis] + 0.0);
    return place;
}

Corners CornerIndex::learn(std::span<const ciel::Index> vertices) {
    Corners corners;
    for (const ciel::Index vertex : vertices)
        corners.push_back(vertices_.try_emplace(place_of(ciel::position(mesh_, vertex)), vertex).first->second);
    return normalised(std::move(corners));
}

Corners CornerIndex::find(vtkDataSet* data, vtkIdType cell) {
    data->GetCellPoints(cell, ids_);
    Corners corners;
    for (vtkIdType i = 0; i < ids_->GetNumberOfIds(); ++i) {
        ciel::Vec3d point{};
        data->GetPoint(ids_->GetId(i), point.data());
        const auto known = vertices_.find(place_of(point));
        if (known != vertices_.end()) corners.push_back(known->second);
    }
    const bool complete = corners.size() == static_cast<std::size_t>(ids_->GetNumberOfIds());
    corners = normalised(std::move(corners));
    return complete || corners.size() >= 3 ? corners : Corners{};
}

} // namespace server::importer
