#include "frames/preview_size.hpp"

#include <algorithm>
#include <cmath>

namespace server::frames {
namespace {

constexpr double most_pixels = 1280.0 * 720.0, fewest_pixels = 320.0 * 180.0;
constexpr double too_slow = 300; // milliseconds
constexpr int slow_enough = 2, most_halvings = 2;

double pixels(geometry::ViewSize view) { return static_cast<double>(view.width) * view.height; }

} // namespace

double PreviewSize::scale(geometry::ViewSize view) const {
    return std::min(1.0, std::sqrt(most_pixels / pixels(view))) / (1 << halvings_);
}

void PreviewSize::took(geometry::ViewSize view, double milliseconds) {
    slow_ = milliseconds > too_slow ? slow_ + 1 : 0;
    const double now = pixels(view) * std::pow(scale(view), 2);
    if (slow_ >= slow_enough && halvings_ < most_halvings && now >= 4 * fewest_pixels) {
        ++halvings_;
        slow_ = 0;
    } else if (halvings_ > 0 && 4 * milliseconds < too_slow) {
        --halvings_;
    }
}

} // namespace server::frames
