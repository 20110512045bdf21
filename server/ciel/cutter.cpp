#include "ciel/cutter.hpp"

namespace ciel {

std::size_t Cutter::memory_bytes() const {
    std::size_t sum = cut_.capacity() * sizeof(CutBlock) + active_.capacity() * sizeof(Index);
    for (const CutBlock& cut : cut_)
        sum += cut.signature.capacity() * sizeof(std::uint64_t) +
               sizeof(Index) * (cut.active.capacity() + cut.polygon_cell.capacity() + cut.polygon_end.capacity() +
                                cut.polygon_point.capacity());
    return sum;
}

} // namespace ciel
