#include "store/cell_places.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/mesh_faces.hpp"

namespace server::store {

std::map<ciel::Index, ciel::Vec3d> cell_places(const ciel::Topology& topology, const ciel::FaceMeshView& points,
                                               const std::vector<ciel::Index>& cells) {
    std::map<ciel::Index, ciel::Vec3d> places;
    for (const ciel::Index cell : cells) {
        if (places.contains(cell)) continue;
        const std::vector<ciel::Index> corners = ciel::corners_of_cell(topology, cell);
        points.load(corners);
        ciel::Vec3d place = points.origin;
        for (const ciel::Index vertex : corners)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] += ciel::position(points, vertex)[axis] / static_cast<double>(corners.size());
        places.emplace(cell, place);
    }
    return places;
}

} // namespace server::store
