// Estimates the memory of a picture before drawing, so that a picture that does not fit is refused with an Error. A
// software GL that runs out of memory while drawing ends the process.
#pragma once

#include "render/frame/frame.hpp"

namespace server::render {

// Returns an upper bound in bytes for a software GL in an existing context, with copies of the primitives, the image
// and its encoding. The numbers were measured with llvmpipe of Mesa 22.3 (tests/bench/results).
[[nodiscard]] std::uint64_t picture_memory(const Frame& frame);

} // namespace server::render
