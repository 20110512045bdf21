// The algorithm that CIEL_ALGORITHM names, for tests of the service that choose none themselves: the suite
// `propagation` runs them a second time. (The program reads the variable where it reads its options:
// server/app/scene_options.cpp.)
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
