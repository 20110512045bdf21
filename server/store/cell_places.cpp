#include "store/cell_places.hpp"

#include "ciel/cell_geometry.hpp"

#include <algorithm>

namespace ciel::store {

std::map<Index, Vec3d> cell_places(const FaceMeshView& mesh, const std::vector<Index>& cells) {
    std::map<Index, Vec3d> places;
    if (cells.empty()) return places;
    std::vector<bool> is_wanted(mesh.cell_count());
    for (const Index cell : cells) is_wanted[cell] = true;
    std::map<Index, std::vector<Index>> corners;
    std::vector<Index> loop;
    for (Index face = 0; face < mesh.face_count(); ++face) {
        const FaceCells beside = read_cells(mesh, face);
        for (const Index cell : {beside.owner, beside.neighbour}) {
            if (cell == none || !is_wanted[cell]) continue;
            read_loop(mesh, face, loop);
            corners[cell].insert(corners[cell].end(), loop.begin(), loop.end());
        }
    }
    for (auto& [cell, vertices] : corners) {
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        Vec3d place = mesh.origin;
        for (const Index vertex : vertices)
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[axis] += position(mesh, vertex)[axis] / static_cast<double>(vertices.size());
        places.emplace(cell, place);
    }
    return places;
}

} // namespace ciel::store
