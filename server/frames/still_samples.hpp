// Default number of samples per pixel of a still. Makes edges smooth, also in software.
#pragma once

namespace ciel::frames {

inline constexpr int default_still_samples = 4;

} // namespace ciel::frames
