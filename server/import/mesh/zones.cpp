#include "import/mesh/zones.hpp"

#include "import/mesh/corner_index.hpp"

#include <algorithm>

namespace server::importer {

namespace {

std::unordered_map<Corners, ciel::Index, CornersHash> cells_by_corners(const ciel::MatchedCells& cells,
                                                                       CornerIndex& index) {
    std::unordered_map<Corners, ciel::Index, CornersHash> by_corners;
    const auto count = static_cast<ciel::Index>(cells.original_cell().size());
    by_corners.reserve(count);
    for (ciel::Index cell = 0; cell < count; ++cell) by_corners.try_emplace(index.learn(cells.corners(cell)), cell);
    return by_corners;
}

} // namespace

std::vector<Zone> match_zones(const ciel::MatchedCells& mesh, const ciel::FaceMeshView& points,
                              const std::vector<InputGrid>& zones) {
    std::vector<Zone> matched;
    if (zones.empty()) return matched;
    CornerIndex index(points);
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
