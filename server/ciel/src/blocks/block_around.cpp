#include "blocks/block_around.hpp"

namespace ciel::detail {

Index first_entry_from(const Block& block, const BlockAround& around, Index local_vertex, Index begin) {
    return around.with([&](const auto& all) {
        Index entry = read_once(all.first_entry[local_vertex]);
        while (entry < begin) { // `entry` is in a standard section, because entries of polyhedra come last
            const std::size_t s = block.section_of_entry(entry);
            entry = next_entry(around.next_entry[s], entry, block.standard[s].entry_begin);
        }
        return entry;
    });
}

} // namespace ciel::detail
