// This work is based on: Y.-D. Liang, B. A. Barsky, "A New Concept and Method for Line Clipping", ACM Transactions on
// Graphics 3(1), 1984.
#include "annotations/overlay.hpp"

#include <algorithm>

namespace server::annotations {

std::optional<std::pair<double, double>> part_inside(const Box& box, const PicturePoint& a, const PicturePoint& b) {
    double from = 0, to = 1;
    const auto cut = [&](double start, double along, double low, double high) {
        if (along == 0) {
            if (start <= low || start >= high) to = from;
            return;
        }
        const double one = (low - start) / along, other = (high - start) / along;
        from = std::max(from, std::min(one, other));
        to = std::min(to, std::max(one, other));
    };
    cut(a.x, b.x - a.x, box.left, box.right);
    cut(a.y, b.y - a.y, box.top, box.bottom);
    if (!(from < to)) return {};
    return std::pair(from, to);
}

} // namespace server::annotations
