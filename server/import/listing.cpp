#include "import/listing.hpp"

#include "import/progress.hpp"
#include "import/values/fields.hpp"

#include <cstdio>

namespace ciel::importer {

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
void print_data_sets(const char* title, const std::vector<DataSet>& data_sets) {
    for (std::size_t first = 0, end; first < data_sets.size(); first = end) {
        const DataSet& data_set = data_sets[first];
        long long points = 0, cells = 0;
        for (end = first; end < data_sets.size(); ++end) {
            const bool is_piece =
                data_set.whole >= 0 && data_sets[end].whole == data_set.whole && data_sets[end].name == data_set.name;
            if (end > first && !is_piece) break;
            points += data_sets[end].data->GetNumberOfPoints();
            cells += data_sets[end].data->GetNumberOfCells();
        }
        const std::string pieces = end - first > 1 ? " in " + std::to_string(end - first) + " pieces" : "";
        std::printf("%s %s: %lld points, %lld cells%s\n", title, data_set.name.c_str(), points, cells, pieces.c_str());
    }
}

} // namespace

void print_listing(Source& source) {
    const auto data = source.read(0, [](double share) { progress(share, "reading the first step"); });
    const DataSets data_sets = collect_data_sets(data);
    require_volumes(data_sets);
    std::printf("format  %s\n", source.format().c_str());
    print_steps(source.times());
    print_data_sets("block  ", data_sets.volumes);
    print_data_sets("surface", data_sets.surfaces);
    print_data_sets("zone   ", data_sets.zones);
    const auto units = source.units();
    for (const FieldName& field : field_names(data_sets)) {
        const auto unit = units.find(field.name);
        const bool known = unit != units.end() && !unit->second.empty();
        std::printf("array   %s: %s, %d component%s%s%s\n", field.name.c_str(),
                    field.of == FieldOf::points ? "points" : "cells", field.components,
                    field.components == 1 ? "" : "s", known ? ", " : "", known ? unit->second.c_str() : "");
    }
}

} // namespace ciel::importer
