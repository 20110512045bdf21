// Algorithm named by the environment variable CIEL_ALGORITHM, for tests that do not select one. The suite `propagation`
// sets it for a second run. The server reads it in server/app/scene_options.cpp.
#pragma once

#include "ciel/extract.hpp"

#include <cstdlib>
#include <string>

namespace ciel::test {

[[nodiscard]] inline Algorithm chosen_algorithm() {
    const char* variable = std::getenv("CIEL_ALGORITHM");
    const std::string name = variable == nullptr ? "signatures" : variable;
    if (name == "signatures") return Algorithm::signatures;
    if (name == "propagation") return Algorithm::propagation;
    fail("CIEL_ALGORITHM is '" + name + "': set it to signatures or propagation");
}

} // namespace ciel::test
