#include "frames/picture_detail.hpp"

#include <algorithm>
#include <span>

namespace server::frames {
namespace {

struct Level {
    PictureDetail::Detail detail;
    double bytes; // approximate size of a picture, relative to the finest level
};
constexpr Level jpeg_levels[]{{{80, 1}, 1},      {{60, 1}, 0.68},    {{40, 1}, 0.5},    {{40, 0.7}, 0.28},
                              {{40, 0.5}, 0.16}, {{40, 0.35}, 0.09}, {{40, 0.25}, 0.05}};
constexpr Level png_levels[]{{{80, 1}, 1}, {{80, 0.7}, 0.55}, {{80, 0.5}, 0.3}, {{80, 0.35}, 0.17}, {{80, 0.25}, 0.09}};

constexpr double fast_enough = 1.0 / 30; // seconds per picture; a higher rate does not justify less detail
// Fractions of the bytes that the line carries until the next picture. `margin` is less than `most`, because
// Level::bytes is approximate and the detail would otherwise alternate between two levels.
constexpr double most = 0.9, margin = 0.75;
constexpr unsigned before_coarser = 2, before_finer = 8;

std::span<const Level> levels_of(wire::MovingCodec codec) {
    if (codec == wire::MovingCodec::jpeg) return jpeg_levels;
    return png_levels;
}

} // namespace

PictureDetail::Detail PictureDetail::of(wire::MovingCodec codec) const {
    const auto levels = levels_of(codec);
    return levels[std::min(level_, levels.size() - 1)].detail;
}

void PictureDetail::sent(wire::MovingCodec codec, std::size_t bytes, double making, double rate) {
    const auto levels = levels_of(codec);
    level_ = std::min(level_, levels.size() - 1);
    const double room = rate * std::max(making, fast_enough); // bytes that the line carries until the next picture
    const double finer = level_ == 0 ? 0 : static_cast<double>(bytes) * levels[level_ - 1].bytes / levels[level_].bytes;
    const bool is_slow = rate > 0;
    too_long_ = is_slow && static_cast<double>(bytes) > most * room ? too_long_ + 1 : 0;
    fitting_ = level_ > 0 && (!is_slow || finer < margin * room) ? fitting_ + 1 : 0;
    if (too_long_ >= before_coarser && level_ + 1 < levels.size()) {
        ++level_;
        too_long_ = 0;
    } else if (fitting_ >= before_finer) {
        --level_;
        fitting_ = 0;
    }
}

} // namespace server::frames
