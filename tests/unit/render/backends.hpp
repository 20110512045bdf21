// Names the parameterized tests after the render back ends of this machine.
#pragma once

#include "render/renderer.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace server::render {
using namespace ciel;

inline std::string name_of_test(const testing::TestParamInfo<Backend>& backend) {
    std::string name = name_of(backend.param);
    std::ranges::replace(name, '-', '_'); // GoogleTest refuses '-' in test names
    return name;
}

} // namespace server::render
