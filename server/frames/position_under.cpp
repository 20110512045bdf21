#include "frames/position_under.hpp"

#include "frames/frame_of.hpp"

#include <cmath>

namespace ciel::frames {

std::optional<Vec3d> position_under(const geometry::Geometry& geometry, const scene::Scene& scene,
                                    geometry::ViewSize size, std::array<double, 2> pixel, const CellLocator& locator,
                                    render::Renderer& renderer, std::function<void()> check_wanted) {
    const auto width = static_cast<int>(size.width), height = static_cast<int>(size.height);
    if (!(pixel[0] >= 0 && pixel[0] < width && pixel[1] >= 0 && pixel[1] < height)) return {};
    render::Image image;
    render::Frame frame = frame_of(geometry, scene, width, height, 1);
    frame.check_wanted = std::move(check_wanted);
    renderer.draw(frame, image);
    Vec3d hit{};
    if (!renderer.pick(static_cast<int>(pixel[0]), static_cast<int>(pixel[1]), hit)) return {};
    if (locator.cell_at(hit) != none) return hit;

    const annotations::Camera& camera = frame.camera;
    const auto& from = camera.parallel ? camera.target : hit;
    Vec3d sight{}, diagonal{};
    double sight_length = 0, size_of_all = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sight[axis] = from[axis] - camera.position[axis];
        diagonal[axis] = geometry.bounds_max[axis] - geometry.bounds_min[axis];
        sight_length += sight[axis] * sight[axis];
        size_of_all += diagonal[axis] * diagonal[axis];
    }
    for (const double share : {1e-5, -1e-5, 1e-4, -1e-4, 1e-3, -1e-3}) {
        Vec3d moved = hit;
        for (std::size_t axis = 0; axis < 3; ++axis)
            moved[axis] += sight[axis] / std::sqrt(sight_length) * share * std::sqrt(size_of_all);
        if (locator.cell_at(moved) != none) return moved;
    }
    return hit;
}

} // namespace ciel::frames
