#include "extraction/cutter.hpp"

#include <string>

namespace ciel {

void Cutter::set_blocks(std::optional<std::span<const Index>> blocks) {
    std::vector<std::uint8_t> has(blocks ? cut_.size() : 0);
    for (const Index b : blocks.value_or(std::span<const Index>())) {
        if (b >= has.size())
            fail("the mesh has no block " + std::to_string(b) + "; it has the blocks 0 to " +
                 std::to_string(cut_.size() - 1));
        has[b] = 1;
    }
    has_ = std::move(has);
}

std::size_t Cutter::memory_bytes() const {
    std::size_t sum = cut_.capacity() * sizeof(ActiveBlock) + active_.capacity() * sizeof(Index) + has_.capacity();
    for (const ActiveBlock& cut : cut_)
        sum += sizeof(std::uint64_t) * (cut.signature.capacity() + cut.active.capacity()) +
               sizeof(Index) * (cut.rank.capacity() + 2 * cut.ends.capacity() + cut.adopted.capacity() +
                                cut.polygon_cell.capacity() + cut.polygon_end.capacity() + cut.polygon_edge.capacity());
    return sum;
}

} // namespace ciel
