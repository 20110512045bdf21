// The test picture of /readyz. It checks that this machine draws correct pixels.
#pragma once

#include "render/renderer.hpp"

#include <string>

namespace server::frames {

struct TestPictureResult {
    bool passed = false; // the pixels are right, and the memory is enough
    std::string gl_renderer{}, gl_version{}, backend{};
    std::string problem{}; // a sentence; empty if the test passed
};

// Draws the test picture and checks its pixels. Also checks that the memory is enough for a usual still picture. Throws
// Error if drawing fails.
[[nodiscard]] TestPictureResult draw_test_picture(render::Renderer& renderer);
[[nodiscard]] bool is_test_picture(const render::Image& image);

} // namespace server::frames
