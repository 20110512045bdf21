#include "import/convert.hpp"
#include "import/fields.hpp"
#include "import/progress.hpp"

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

// Pieces that share a name are one line.
void print_blocks(const char* title, const std::vector<Block>& blocks) {
    for (std::size_t first = 0, end; first < blocks.size(); first = end) {
        const Block& block = blocks[first];
        long long points = 0, cells = 0;
        for (end = first; end < blocks.size(); ++end) {
            const bool is_piece =
                block.whole >= 0 && blocks[end].whole == block.whole && blocks[end].name == block.name;
            if (end > first && !is_piece) break;
            points += blocks[end].data->GetNumberOfPoints();
            cells += blocks[end].data->GetNumberOfCells();
        }
        const std::string pieces = end - first > 1 ? " in " + std::to_string(end - first) + " pieces" : "";
        std::printf("%s %s: %lld points, %lld cells%s\n", title, block.name.c_str(), points, cells, pieces.c_str());
    }
}

} // namespace

void print_listing(Source& source) {
    const auto data = source.read(0, [](double share) { progress(share, "reading the first step"); });
    const Blocks blocks = collect_blocks(data);
    require_volumes(blocks);
    std::printf("format  %s\n", source.format().c_str());
    print_steps(source.times());
    print_blocks("block  ", blocks.volumes);
    print_blocks("surface", blocks.surfaces);
    print_blocks("zone   ", blocks.zones);
    const auto units = source.units();
    for (const FieldName& field : field_names(blocks)) {
        const auto unit = units.find(field.name);
        const bool known = unit != units.end() && !unit->second.empty();
        std::printf("array   %s: %s, %d component%s%s%s\n", field.name.c_str(),
                    field.of == FieldOf::points ? "points" : "cells", field.components,
                    field.components == 1 ? "" : "s", known ? ", " : "", known ? unit->second.c_str() : "");
    }
}

} // namespace ciel::importer
