#include "import/mesh/zones.hpp"

#include "import/mesh/corner_index.hpp"

#include <algorithm>

namespace server::importer {

namespace {

std::unordered_map<Corners, ciel::Index, CornersHash> cells_by_corners(const ciel::FaceMeshView& mesh,
                                                                       CornerIndex& index) {
    std::vector<std::vector<ciel::Index>> vertices(mesh.cell_count());
    for (ciel::Index face = 0; face < mesh.face_count(); ++face)
        for (const ciel::Index cell : {mesh.owner[face], mesh.neighbour[face]})
            if (cell != ciel::none)
                vertices[cell].insert(vertices[cell].end(), mesh.loop(face).begin(), mesh.loop(face).end());
    std::unordered_map<Corners, ciel::Index, CornersHash> cells;
    cells.reserve(vertices.size());
    for (ciel::Index cell = 0; cell < vertices.size(); ++cell) {
        cells.try_emplace(index.learn(vertices[cell]), cell);
        vertices[cell] = {};
    }
    return cells;
}

} // namespace

std::vector<Zone> match_zones(const ciel::FaceMeshView& mesh, const std::vector<InputGrid>& zones) {
    std::vector<Zone> matched;
    if (zones.empty()) return matched;
    CornerIndex index(mesh);
    const auto cells = cells_by_corners(mesh, index);
    for (const InputGrid& input_grid : zones) {
        Zone zone{input_grid.name, {}, 0};
        for (vtkIdType cell = 0; cell < input_grid.data->GetNumberOfCells(); ++cell) {
            const auto found = cells.find(index.find(input_grid.data, cell));
            if (found == cells.end())
                ++zone.unmatched;
            else
                zone.cells.push_back(found->second);
        }
        std::sort(zone.cells.begin(), zone.cells.end());
        matched.push_back(std::move(zone));
    }
    return matched;
}

} // namespace server::importer
