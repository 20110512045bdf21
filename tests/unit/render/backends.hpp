// Tests of every back end that this machine has.
#pragma once

#include "render/renderer.hpp"

#include <algorithm>
#include <gtest/gtest.h>

namespace ciel::render {

inline std::string name_of_test(const testing::TestParamInfo<Backend>& backend) {
    std::string name = name_of(backend.param);
    std::ranges::replace(name, '-', '_'); // which GoogleTest does not take
    return name;
}

} // namespace ciel::render
