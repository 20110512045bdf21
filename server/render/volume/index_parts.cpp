#include "render/volume/index_parts.hpp"

#include <algorithm>

namespace ciel::render {
namespace {

constexpr std::size_t most_corners = 3 * std::size_t{256}; // indices per part; smaller parts are not worth a draw call

IndexPart part_of(std::span<const Index> corners, const std::function<const Vec3f&(Index)>& at) {
    IndexPart part{{}, at(corners[0]), at(corners[0])};
    for (const Index corner : corners) {
        const Vec3f& place = at(corner);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            part.low[axis] = std::min(part.low[axis], place[axis]);
            part.high[axis] = std::max(part.high[axis], place[axis]);
        }
    }
    return part;
}

} // namespace

std::vector<IndexPart> parts_of(const IndexRange& range, std::span<const Index> triangles,
                                const std::function<const Vec3f&(Index)>& at) {
    std::vector<IndexPart> parts;
    parts.reserve((triangles.size() + most_corners - 1) / most_corners);
    for (std::size_t first = 0; first < triangles.size(); first += most_corners) {
        const auto corners = triangles.subspan(first, std::min(most_corners, triangles.size() - first));
        parts.push_back(part_of(corners, at));
        parts.back().range = {range.first + first, static_cast<GLsizei>(corners.size()), range.base};
    }
    return parts;
}

} // namespace ciel::render
