#include "store/cell_extremes.hpp"

namespace server::store {
namespace {

std::optional<LowestAndHighest> extremes_in(const store::Dataset& dataset, const std::string& array, std::size_t row,
                                            std::size_t step) {
    const store::Step& at = dataset.steps().at(step);
    const auto written = at.arrays.find(array);
    if (written == at.arrays.end() || written->second.extremes.empty()) return {};
    const store::ArrayStep& found = written->second;
    const auto& [low, high] = row == 0 ? found.range : found.component_ranges.at(row - 1);
    const auto value_of = [&](double value, const store::CellExtreme& extreme) {
        return CellValue{value, dataset.original_cell(at.mesh, extreme.cell), extreme.place, at.time};
    };
    const store::CellExtremes& extremes = found.extremes.at(row);
    return LowestAndHighest{value_of(low, extremes.lowest), value_of(high, extremes.highest)};
}

} // namespace

std::optional<LowestAndHighest> cell_extremes(const store::Dataset& dataset, const std::string& scalar,
                                              std::size_t step) {
    const std::string of_cells = store::cell_scalar(dataset, scalar);
    if (of_cells.empty()) return {};
    const store::ScalarName name = store::parse_scalar(dataset, of_cells);
    return extremes_in(dataset, name.array, name.component ? 1 + static_cast<std::size_t>(*name.component) : 0, step);
}

std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset, const store::ArrayInfo& array,
                                               std::size_t step) {
    const std::string of_cells = store::cell_scalar(dataset, store::scalar_names(array).front());
    if (of_cells.empty()) return {};
    return extremes_in(dataset, store::parse_scalar(dataset, of_cells).array, 0, step);
}

std::optional<LowestAndHighest> range_extremes(const store::Dataset& dataset, const store::ArrayInfo& array) {
    std::optional<LowestAndHighest> all;
    for (std::size_t step = 0; step < dataset.steps().size(); ++step) {
        const auto here = range_extremes(dataset, array, step);
        if (!here) continue;
        if (!all) all = here;
        if (here->lowest.value < all->lowest.value) all->lowest = here->lowest;
        if (here->highest.value > all->highest.value) all->highest = here->highest;
    }
    return all;
}

} // namespace server::store
