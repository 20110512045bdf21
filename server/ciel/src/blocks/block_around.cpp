#include "blocks/block_around.hpp"

namespace ciel {

Index BlockAround::border_place_of(Index local_vertex) const {
    return with([&](const auto& all) {
        const auto found = std::ranges::lower_bound(all.border_vertex, local_vertex);
        return found != all.border_vertex.end() && *found == local_vertex
                   ? static_cast<Index>(found - all.border_vertex.begin())
                   : none;
    });
}

Index first_entry_from(const Block& block, const BlockAround& around, Index local_vertex, Index begin) {
    return around.with([&](const auto& all) {
        Index entry = all.first_entry[local_vertex];
        while (entry < begin) { // in a standard section, because polyhedra have the last entries
            const std::size_t s = block.section_of_entry(entry);
            entry = around.next_entry[s][entry - block.standard[s].entry_begin];
        }
        return entry;
    });
}

} // namespace ciel
