// What a picture takes of memory before it is drawn, so that one that does not fit is refused in words: a software GL
// that finds no memory while it draws ends the process.
#pragma once

#include "render/frame/frame.hpp"

namespace ciel::render {

// Bytes that drawing this frame takes at most in software, beside the making of the context: sheets of the GL, copies
// of the meshes, the image and its encoding. Measured with llvmpipe of Mesa 22.3 (tests/bench/results).
[[nodiscard]] std::uint64_t picture_memory(const Frame& frame);

} // namespace ciel::render
