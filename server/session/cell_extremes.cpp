#include "session/cell_extremes.hpp"

namespace ciel::session {

std::optional<LowestAndHighest> cell_extremes(const store::Dataset& dataset, const std::string& scalar,
                                              std::size_t step) {
    const std::string of_cells = store::cell_scalar(dataset, scalar);
    if (of_cells.empty()) return {};
    const store::ScalarName name = store::parse_scalar(dataset, of_cells);
    const store::Step& at = dataset.steps().at(step);
    const auto written = at.arrays.find(name.array);
    if (written == at.arrays.end() || written->second.extremes.empty()) return {};
    const store::ArrayStep& array = written->second;
    const auto row = name.component ? 1 + static_cast<std::size_t>(*name.component) : std::size_t{0};
    const auto& [low, high] = row == 0 ? array.range : array.component_ranges.at(row - 1);
    const auto ids = dataset.original_cell(at.mesh);
    const auto found = [&](double value, const store::CellExtreme& extreme) {
        return CellValue{value, ids[extreme.cell], extreme.place, at.time};
    };
    const store::CellExtremes& extremes = array.extremes.at(row);
    return LowestAndHighest{found(low, extremes.lowest), found(high, extremes.highest)};
}

std::optional<LowestAndHighest> cell_extremes_of_all_steps(const store::Dataset& dataset, const std::string& scalar) {
    std::optional<LowestAndHighest> all;
    for (std::size_t step = 0; step < dataset.steps().size(); ++step) {
        const auto here = cell_extremes(dataset, scalar, step);
        if (!here) continue;
        if (!all) all = here;
        if (here->lowest.value < all->lowest.value) all->lowest = here->lowest;
        if (here->highest.value > all->highest.value) all->highest = here->highest;
    }
    return all;
}

} // namespace ciel::session
