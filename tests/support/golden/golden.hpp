// Compares pictures with golden pictures, tests/golden/pictures/NAME.png.
#pragma once

#include "support/golden/difference.hpp"

#include <gtest/gtest.h>
#include <string>

namespace ciel::test {

// Usage: EXPECT_TRUE(matches_golden("name", picture)). A missing golden picture is a failure.
// On failure, writes three files into pictures/golden of the build folder: NAME.actual.png, NAME.expected.png and
// NAME.difference.png. A later success removes them.
// `label` distinguishes the files of pictures that share one golden picture, for example one per back end.
// With CIEL_ACCEPT_PICTURES=1 in the environment, the picture becomes the golden picture. Inspect it before the commit.
[[nodiscard]] testing::AssertionResult matches_golden(const std::string& name, const Picture& picture,
                                                      const std::string& label = {}, const Tolerance& tolerance = {});

} // namespace ciel::test
