#include "render/volume/boxed_ranges.hpp"

#include <algorithm>

namespace server::render {
namespace {

constexpr std::size_t most_corners = 3 * std::size_t{256}; // per range; smaller ranges would cost too many draw calls

BoxedRange boxed_range_of(std::span<const ciel::Index> corners,
                          const std::function<const ciel::Vec3f&(ciel::Index)>& at) {
    BoxedRange boxed{{}, at(corners[0]), at(corners[0])};
    for (const ciel::Index corner : corners) {
        const ciel::Vec3f& place = at(corner);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            boxed.low[axis] = std::min(boxed.low[axis], place[axis]);
            boxed.high[axis] = std::max(boxed.high[axis], place[axis]);
        }
    }
    return boxed;
}

} // namespace

std::vector<BoxedRange> boxed_ranges_of(const IndexRange& range, std::span<const ciel::Index> triangles,
                                        const std::function<const ciel::Vec3f&(ciel::Index)>& at) {
    std::vector<BoxedRange> ranges;
    ranges.reserve((triangles.size() + most_corners - 1) / most_corners);
    for (std::size_t first = 0; first < triangles.size(); first += most_corners) {
        const auto corners = triangles.subspan(first, std::min(most_corners, triangles.size() - first));
        ranges.push_back(boxed_range_of(corners, at));
        ranges.back().range = {range.first + first, static_cast<GLsizei>(corners.size()), range.base};
    }
    return ranges;
}

} // namespace server::render
