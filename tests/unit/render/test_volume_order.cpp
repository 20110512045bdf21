#include "render/volume/volume_order.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <random>

namespace server::render {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<SlabOfVolume> order(const std::vector<SlabRow>& rows, double eye) { return back_to_front(rows, eye); }

TEST(VolumeOrder, OfOneVolumeRunsToTheEyeFromBothEnds) {
    EXPECT_EQ(order({{0, 1, 3}}, infinity), (std::vector<SlabOfVolume>{{0, 0}, {0, 1}, {0, 2}}));
    EXPECT_EQ(order({{0, 1, 3}}, -infinity), (std::vector<SlabOfVolume>{{0, 2}, {0, 1}, {0, 0}}));
    EXPECT_EQ(order({{0, 1, 4}}, 1.5), (std::vector<SlabOfVolume>{{0, 0}, {0, 3}, {0, 2}, {0, 1}}));
}

TEST(VolumeOrder, SlabsInTheSamePlaceTakeTurns) {
    EXPECT_EQ(order({{0, 1, 3}, {0, 1, 3}}, infinity),
              (std::vector<SlabOfVolume>{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 2}, {1, 2}}));
    EXPECT_EQ(order({{0, 1, 2}, {1e-9, 1, 2}, {0, 1, 2}}, -infinity),
              (std::vector<SlabOfVolume>{{2, 1}, {1, 1}, {0, 1}, {0, 0}, {1, 0}, {2, 0}}));
}

TEST(VolumeOrder, ThickSlabsStandInTheMiddleOfTheThinOnesInThem) {
    EXPECT_EQ(order({{0, 2, 2}, {0, 1, 4}}, infinity),
              (std::vector<SlabOfVolume>{{1, 0}, {0, 0}, {1, 1}, {1, 2}, {0, 1}, {1, 3}}));
    EXPECT_EQ(order({{0, 3, 1}, {0, 1, 3}}, infinity), (std::vector<SlabOfVolume>{{1, 0}, {0, 0}, {1, 1}, {1, 2}}));
}

TEST(VolumeOrder, PiecesOfSlabsInTheSamePlaceStandBetweenEachOther) {
    const std::vector<SlabRow> alike{{0, 1, 2}, {0, 1, 2}};
    EXPECT_EQ(back_to_front(std::vector<SlabRow>{{0, 1, 2}}, infinity, {4, 4}),
              (std::vector<SlabOfVolume>{{0, 0}, {0, 1}}));
    EXPECT_EQ(back_to_front(alike, infinity, {2, 4}),
              (std::vector<SlabOfVolume>{{0, 0, 0.5}, {1, 0}, {0, 0, 0.5}, {1, 1, 0.5}, {0, 1}, {1, 1, 0.5}}));
    EXPECT_EQ(back_to_front(alike, infinity, {9, 1}), back_to_front(alike, infinity));
    EXPECT_EQ(back_to_front(alike, infinity, {1, 4}), back_to_front(alike, infinity));
}

TEST(VolumeOrder, SlabsAreDividedAtEachOthersBordersAndAtTheEye) {
    EXPECT_EQ(back_to_front(std::vector<SlabRow>{{0, 2, 1}, {0, 1, 2}}, infinity, {1, 4}),
              (std::vector<SlabOfVolume>{{0, 0, 0.5}, {1, 0}, {1, 1}, {0, 0, 0.5}}));
    // After the eye has passed the first slab's slice, the second slab's slice is drawn for the rest of the first slab.
    EXPECT_EQ(back_to_front(std::vector<SlabRow>{{0, 1, 2}, {0, 1, 2}}, 0.75, {1.6, 4}),
              (std::vector<SlabOfVolume>{
                  {0, 0, 0.5}, {1, 0}, {0, 0, 0.5}, {1, 1, 0.4}, {0, 1, 0.8}, {1, 1, 0.4 + 0.2}, {0, 1, 0.2}}));
}

// However slabs are divided, the shares of each slab add up to 1.
TEST(VolumeOrder, PiecesMakeUpTheirSlabs) {
    std::mt19937 random(7); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run
    std::uniform_real_distribution<double> place(-3, 3);
    for (int run = 0; run < 200; ++run) {
        std::vector<SlabRow> rows;
        for (int i = 0; i < 2 + run % 3; ++i)
            rows.push_back({place(random), 0.05 + std::abs(place(random)) / 4, 1 + random() % 40});
        const double eye = run % 5 == 0 ? infinity : place(random);
        std::map<std::pair<std::size_t, std::size_t>, double> shares;
        for (const auto& [volume, slab, share] : back_to_front(rows, eye, {20, 1 + random() % 4}))
            shares[{volume, slab}] += share;
        std::size_t slabs = 0;
        for (const SlabRow& row : rows) slabs += row.count;
        EXPECT_EQ(shares.size(), slabs);
        for (const auto& [slab, share] : shares) EXPECT_NEAR(share, 1, 1e-5);
    }
}

// Random rows and eyes: each slab occurs once, and slab centers approach the eye on both sides.
TEST(VolumeOrder, RunsToTheEyeWhateverTheRows) {
    std::mt19937 random(5); // NOLINT(cert-msc32-c,cert-msc51-cpp): the same in every run
    std::uniform_real_distribution<double> place(-3, 3);
    for (int run = 0; run < 200; ++run) {
        std::vector<SlabRow> rows;
        std::size_t slabs = 0;
        for (int i = 0; i < 1 + run % 4; ++i) {
            rows.push_back({place(random), 0.05 + std::abs(place(random)) / 4, 1 + random() % 40});
            slabs += rows.back().count;
        }
        const double eye = run % 5 == 0 ? infinity : place(random);
        const std::vector<SlabOfVolume> all = order(rows, eye);
        ASSERT_EQ(all.size(), slabs);
        std::vector<std::vector<bool>> seen;
        seen.reserve(rows.size());
        for (const SlabRow& row : rows) seen.emplace_back(row.count, false);
        double below = -infinity, above = infinity;
        for (const auto& [volume, slab, share] : all) {
            ASSERT_EQ(share, 1);
            const SlabRow& row = rows[volume];
            ASSERT_FALSE(seen[volume][slab]);
            seen[volume][slab] = true;
            const double end = row.first + static_cast<double>(slab + 1) * row.thickness,
                         middle = end - row.thickness / 2;
            double& last = end <= eye ? below : above;
            EXPECT_GE((end <= eye ? 1 : -1) * (middle - last), -1e-5);
            last = middle;
        }
    }
}

} // namespace
} // namespace server::render
