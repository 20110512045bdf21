#include "import/listing.hpp"

#include "import/progress.hpp"
#include "import/values/fields.hpp"

#include <cstdio>

namespace server::importer {

namespace {

void print_steps(const std::vector<double>& times) {
    std::printf("steps   %zu:", times.size());
    constexpr std::size_t shown = 8;
    for (std::size_t i = 0; i < times.size(); ++i) {
        if (times.size() > shown && i == shown - 1) {
            std::printf(" ... %g", times.back());
            break;
        }
        std::printf(" %g", times[i]);
    }
    std::printf("\n");
}

// Pieces of one mesh with the same name share one line.
void print_input_grids(const char* title, const std::vector<InputGrid>& input_grids) {
    for (std::size_t first = 0, end; first < input_grids.size(); first = end) {
        const InputGrid& input_grid = input_grids[first];
        long long points = 0, cells = 0;
        for (end = first; end < input_grids.size(); ++end) {
            const bool is_piece = input_grid.whole >= 0 && input_grids[end].whole == input_grid.whole &&
                                  input_grids[end].name == input_grid.name;
            if (end > first && !is_piece) break;
            points += input_grids[end].data->GetNumberOfPoints();
            cells += input_grids[end].data->GetNumberOfCells();
        }
        const std::string pieces = end - first > 1 ? " in " + std::to_string(end - first) + " pieces" : "";
        std::printf("%s %s: %lld points, %lld cells%s\n", title, input_grid.name.c_str(), points, cells,
                    pieces.c_str());
    }
}

} // namespace

void print_listing(Source& source) {
    const auto data = source.read(0, [](double share) { progress(share, "reading the first step"); });
    const InputGrids input_grids = collect_input_grids(data);
    require_volumes(input_grids);
    std::printf("format  %s\n", source.format().c_str());
    print_steps(source.times());
    print_input_grids("block  ", input_grids.volumes);
    print_input_grids("surface", input_grids.surfaces);
    print_input_grids("zone   ", input_grids.zones);
    const auto units = source.units();
    for (const FieldName& field : field_names(input_grids)) {
        const auto unit = units.find(field.name);
        const bool known = unit != units.end() && !unit->second.empty();
        std::printf("array   %s: %s, %d component%s%s%s\n", field.name.c_str(),
                    field.of == FieldOf::points ? "points" : "cells", field.components,
                    field.components == 1 ? "" : "s", known ? ", " : "", known ? unit->second.c_str() : "");
    }
}

} // namespace server::importer
