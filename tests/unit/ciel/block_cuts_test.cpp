// BlockCuts keeps the cuts of blocks that a query's surface has left.
#include "blocks/block_cuts.hpp"

#include <gtest/gtest.h>
#include <numeric>

namespace ciel {
namespace {

using detail::BlockCuts;

std::vector<Index> blocks_from(Index begin, std::size_t count) {
    std::vector<Index> blocks(count);
    std::iota(blocks.begin(), blocks.end(), begin);
    return blocks;
}

void cut(BlockCuts& cuts, const std::vector<Index>& blocks) {
    cuts.keep(blocks);
    for (const Index b : blocks) {
        cuts[b].known = true;
        cuts[b].polygon_cell.assign(100, b);
    }
}

constexpr std::size_t many = 2 * BlockCuts::always_kept;

TEST(BlockCuts, ACutThatReturnsIsStillKnown) {
    BlockCuts cuts(10);
    cut(cuts, {1, 2, 3});
    cut(cuts, {3, 4});
    cuts.keep(std::vector<Index>{1, 2, 9});
    EXPECT_TRUE(cuts[1].known);
    EXPECT_EQ(cuts[2].polygon_cell.front(), 2U);
    EXPECT_FALSE(cuts[9].known);
    cuts.forget();
    EXPECT_FALSE(cuts[1].known);
    cuts.keep(std::vector<Index>{4});
    EXPECT_FALSE(cuts[4].known) << "forgotten, too, although the surface had left it";
}

TEST(BlockCuts, MemoryFollowsFromTheSurface) {
    BlockCuts cuts(20 * many);
    cut(cuts, blocks_from(0, many));
    cut(cuts, blocks_from(many, many));
    const std::size_t of_two = cuts.memory_bytes();
    for (Index at = 2; at < 20; ++at) cut(cuts, blocks_from(at * many, many));
    EXPECT_LE(cuts.memory_bytes(), of_two + of_two / 10);
    cut(cuts, {0});
    EXPECT_LE(cuts.memory_bytes(), of_two * 6 / 10) << "a small surface keeps a fixed number of the others";
}

TEST(BlockCuts, TheBlockThatWasLeftFirstGivesItsBuffers) {
    BlockCuts cuts(4 * many);
    cut(cuts, blocks_from(0, many));
    cut(cuts, blocks_from(many, many));
    const Index* const buffer = cuts[many].polygon_cell.data();
    cut(cuts, blocks_from(2 * many, many)); // reuses the buffers of the blocks from 0 on
    cuts.keep(blocks_from(many, many));
    EXPECT_TRUE(cuts[many].known);
    EXPECT_EQ(cuts[many].polygon_cell.data(), buffer);
    cuts.keep(blocks_from(0, 1));
    EXPECT_FALSE(cuts[0].known);
}

} // namespace
} // namespace ciel
