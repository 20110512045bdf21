#include "extraction/cutter.hpp"

#include <string>

namespace ciel::detail {

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
    return cut_.memory_bytes() + active_.capacity() * sizeof(Index) + has_.capacity();
}

} // namespace ciel::detail
