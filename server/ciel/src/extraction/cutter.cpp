#include "extraction/cutter.hpp"

namespace ciel {

std::size_t Cutter::memory_bytes() const {
    std::size_t sum = cut_.capacity() * sizeof(ActiveBlock) + active_.capacity() * sizeof(Index);
    for (const ActiveBlock& cut : cut_)
        sum += sizeof(std::uint64_t) * (cut.signature.capacity() + cut.active.capacity()) +
               sizeof(Index) * (cut.rank.capacity() + 2 * cut.ends.capacity() + cut.polygon_cell.capacity() +
                                cut.polygon_end.capacity() + cut.polygon_edge.capacity());
    return sum;
}

} // namespace ciel
