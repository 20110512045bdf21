#include "render/annotations/make_room.hpp"

#include "render/annotations/box_edges.hpp"
#include "render/annotations/page.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

namespace ciel::render {
namespace {

constexpr int usual_height = 720; // the layout is judged at this size, but for smaller pictures
constexpr double step = 1.03, furthest = 2;
constexpr double aside = 1.0 / 32; // of the picture's width, so many times at most
constexpr int most_aside = 10;
constexpr int samples = 24;                             // of an edge
constexpr double beside_edges = 0.5, beside_axes = 4.5; // ems around the edges; numbers and names take the larger one

glm::dvec3 corner(const Frame& frame, unsigned bits) {
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        at[axis] = (bits >> k & 1U) != 0 ? frame.bounds_max[k] : frame.bounds_min[k];
    }
    return at;
}

std::vector<glm::dvec3> points_of_edges(const Frame& frame) {
    std::vector<glm::dvec3> points;
    for (unsigned from = 0; from < 8; ++from)
        for (unsigned bit = 1; bit < 8; bit <<= 1U) {
            if ((from & bit) != 0) continue;
            for (int i = 0; i <= samples; ++i)
                points.push_back(
                    glm::mix(corner(frame, from), corner(frame, from | bit), static_cast<double>(i) / samples));
        }
    return points;
}

bool is_clear(const Frame& frame, const std::vector<glm::dvec3>& points, const Page& page) {
    const Projection projection(frame);
    const double room = (frame.annotations.axes ? beside_axes : beside_edges) * page.em();
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
        if (!(projection.clip(point).w > 0)) return false;
        const Place at = projection.pixel(point);
        return page.is_free({at.x - room, at.y - room, at.x + room, at.y + room});
    });
}

void step_back(Camera& camera, double by = step) {
    for (std::size_t k = 0; k < 3; ++k)
        camera.position[k] = camera.target[k] + by * (camera.position[k] - camera.target[k]);
    camera.parallel_height *= by;
}

// Moves what is seen to the left and down, by shares of the picture's width.
Camera stepped_aside(const Frame& frame, double to_left, double down) {
    const glm::dmat4 view = view_transform(frame).view;
    const glm::dvec3 right(view[0].x, view[1].x, view[2].x);
    const glm::dvec3 up(view[0].y, view[1].y, view[2].y);
    Camera camera = frame.camera;
    const auto distance = [](const Vec3d& a, const Vec3d& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    const double height =
        camera.parallel ? camera.parallel_height
                        : 2 * distance(camera.position, camera.target) * std::tan(glm::radians(camera.fov_degrees) / 2);
    const glm::dvec3 shift = height * frame.width / frame.height * (to_left * right + down * up);
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        camera.position[at] += shift[k];
        camera.target[at] += shift[k];
    }
    return camera;
}

// In a narrow picture the legends reach so far that nothing in the middle is clear of them: left of them, or below.
std::optional<Camera> clear_aside(Frame frame, const std::vector<glm::dvec3>& points, const Page& page) {
    constexpr double large_step = 1.1, furthest_aside = 3;
    double away = 1;
    while (away < furthest_aside) {
        for (int i = 1; i <= most_aside; ++i)
            for (const auto& [to_left, down] : {std::pair(1, 0), {0, 1}, {0, 2}}) { // narrow pictures are high
                Frame moved = frame;
                moved.camera = stepped_aside(frame, i * to_left * aside, i * down * aside);
                if (is_clear(moved, points, page)) return moved.camera;
            }
        away *= large_step;
        step_back(frame.camera, large_step);
    }
    return {};
}

} // namespace

Camera clear_of_annotations(const Frame& frame) {
    if (frame.annotations.empty()) return frame.camera;
    Frame judged = frame;
    judged.meshes.clear();
    Font font;
    if (!Page(frame, font).has_smallest_text()) { // all that is written keeps its share of the picture
        judged.width =
            std::max(1, static_cast<int>(std::lround(static_cast<double>(frame.width) / frame.height * usual_height)));
        judged.height = usual_height;
    }
    Page page(judged, font);
    lay_title(page, judged.annotations);
    lay_captions(page, judged.annotations);
    lay_legends(page, judged.annotations);
    if (judged.annotations.triad) lay_triad(page, judged);
    const std::vector<glm::dvec3> points = points_of_edges(judged);
    double away = 1;
    while (away < furthest) {
        if (is_clear(judged, points, page)) return judged.camera;
        away *= step;
        step_back(judged.camera);
    }
    judged.camera = frame.camera;
    return clear_aside(judged, points, page).value_or(frame.camera);
}

} // namespace ciel::render
