#include "frames/position_under.hpp"

#include "ciel/vector_operators.hpp"
#include "frames/frame_of.hpp"

#include <algorithm>

namespace server::frames {

using ciel::operator*;
using ciel::operator+;
using ciel::operator-;

std::optional<ciel::Vec3d> position_under(const geometry::Geometry& geometry, const scene::CheckedScene& checked,
                                          geometry::ViewSize size, std::array<double, 2> pixel,
                                          const ciel::CellLocator& locator, render::Renderer& renderer,
                                          std::function<void()> check_wanted) {
    const auto width = static_cast<int>(size.width), height = static_cast<int>(size.height);
    if (!(pixel[0] >= 0 && pixel[0] < width && pixel[1] >= 0 && pixel[1] < height)) return {};
    render::Image image;
    render::Frame frame = frame_of(geometry, checked, width, height, 1);
    frame.check_wanted = std::move(check_wanted);
    renderer.draw(frame, image);
    ciel::Vec3d hit{};
    if (!renderer.pick(static_cast<int>(pixel[0]), static_cast<int>(pixel[1]), hit)) return {};
    if (locator.cell_at(hit) != ciel::none) return hit;

    const annotations::ViewCamera& camera = frame.camera;
    const ciel::Vec3d sight = (camera.parallel ? camera.target : hit) - camera.position;
    const double whole = ciel::length(geometry.bounds_max - geometry.bounds_min);
    const double seen = std::min(whole, camera.parallel ? camera.parallel_height : ciel::length(sight));
    // Tries small steps first, for thin cells of boundary layers, then steps as large as the depth buffer's error.
    for (const double reach : {seen, whole})
        for (const double share : {1e-5, -1e-5, 1e-4, -1e-4, 1e-3, -1e-3}) {
            const ciel::Vec3d moved = hit + share * reach / ciel::length(sight) * sight;
            if (locator.cell_at(moved) != ciel::none) return moved;
        }
    return hit;
}

} // namespace server::frames
