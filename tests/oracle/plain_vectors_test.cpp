// Gradients with plain vectors (CIEL_PLAIN_VECTORS) have the bits of those with the vector extensions of the compiler.
#include "ciel/types.hpp"
#include "oracle/vectors/gradient_bits.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace ciel::test {
namespace {

class PlainVectors : public testing::TestWithParam<CellType> {};

TEST_P(PlainVectors, GiveTheSameBits) {
    const auto type = static_cast<std::uint8_t>(GetParam());
    const std::vector<std::uint64_t> expected = gradient_bits(type), found = ciel_plain::test::gradient_bits(type);
    ASSERT_EQ(expected.size(), found.size());
    for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_EQ(expected[i], found[i]) << i;
    const auto zeros = static_cast<std::size_t>(std::ranges::count(expected, std::uint64_t{0}));
    EXPECT_LT(zeros, expected.size() / 2);
}

INSTANTIATE_TEST_SUITE_P(Types, PlainVectors,
                         testing::Values(CellType::tetrahedron, CellType::hexahedron, CellType::wedge,
                                         CellType::pyramid));

} // namespace
} // namespace ciel::test
