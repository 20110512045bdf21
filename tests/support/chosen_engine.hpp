// The engine that CIEL_ENGINE names, for tests of the service that choose none themselves: the suite `propagation` runs
// them a second time. (The program reads the variable where it reads its options: server/app/scene_options.cpp.)
#pragma once

#include "ciel/extract.hpp"

#include <cstdlib>
#include <string>

namespace ciel::test {

[[nodiscard]] inline Engine chosen_engine() {
    const char* variable = std::getenv("CIEL_ENGINE");
    const std::string name = variable == nullptr ? "signatures" : variable;
    if (name == "signatures") return Engine::signatures;
    if (name == "propagation") return Engine::propagation;
    fail("CIEL_ENGINE is '" + name + "': set it to signatures or propagation");
}

} // namespace ciel::test
