// Golden images: tests/golden/pictures/NAME.png is what the picture looked like when somebody last looked at it.
#pragma once

#include "support/golden/difference.hpp"

#include <gtest/gtest.h>
#include <string>

namespace ciel::test {

// EXPECT_TRUE(matches_golden("name", picture)). On failure the build folder's pictures/golden holds what was drawn
// (NAME.actual.png), what it should look like (NAME.expected.png) and where they differ (NAME.difference.png); they
// go away when the test passes again. A picture without a golden image fails too. `label` tells apart pictures that
// share one golden image, such as one per back end.
// With CIEL_ACCEPT_PICTURES=1 in the environment the picture becomes the golden image: look at it before it is
// committed.
[[nodiscard]] testing::AssertionResult matches_golden(const std::string& name, const Picture& picture,
                                                      const std::string& label = {}, const Tolerance& tolerance = {});

} // namespace ciel::test
