#include "annotations/make_room.hpp"

#include "annotations/box_edges.hpp"
#include "annotations/layout.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <optional>

namespace server::annotations {
namespace {

constexpr int usual_height = 720; // height in pixels of the layout that is tested, unless text has its smallest size
constexpr double step = 1.03, furthest = 2;
constexpr double aside = 1.0 / 32; // one step to the side, as a fraction of the picture's width
constexpr int most_aside = 10;
constexpr int samples = 24; // number of intervals into which each edge of the bounds is divided
constexpr double beside_edges = 0.5, beside_axes = 4.5; // ems to keep free around the edges of the bounds

glm::dvec3 corner(const AnnotatedPicture& picture, unsigned bits) {
    glm::dvec3 at;
    for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<std::size_t>(axis);
        at[axis] = (bits >> k & 1U) != 0 ? picture.bounds_max[k] : picture.bounds_min[k];
    }
    return at;
}

std::vector<glm::dvec3> points_of_edges(const AnnotatedPicture& picture) {
    std::vector<glm::dvec3> points;
    for (unsigned from = 0; from < 8; ++from)
        for (unsigned bit = 1; bit < 8; bit <<= 1U) {
            if ((from & bit) != 0) continue;
            for (int i = 0; i <= samples; ++i)
                points.push_back(
                    glm::mix(corner(picture, from), corner(picture, from | bit), static_cast<double>(i) / samples));
        }
    return points;
}

bool is_clear(const AnnotatedPicture& picture, const std::vector<glm::dvec3>& points, const Layout& layout) {
    const Projection projection(picture);
    const double room = (picture.annotations.axes ? beside_axes : beside_edges) * layout.em();
    return std::all_of(points.begin(), points.end(), [&](const glm::dvec3& point) {
        if (!(projection.clip(point).w > 0)) return false;
        const PicturePoint at = projection.pixel(point);
        return layout.is_free({at.x - room, at.y - room, at.x + room, at.y + room});
    });
}

void step_back(ViewCamera& camera, double by = step) {
    for (std::size_t k = 0; k < 3; ++k)
        camera.position[k] = camera.target[k] + by * (camera.position[k] - camera.target[k]);
    camera.parallel_height *= by;
}

// Moves the scene to the left and down in the picture, by fractions of the picture's width.
ViewCamera stepped_aside(const AnnotatedPicture& picture, double to_left, double down) {
    const glm::dmat4 view = view_transform(picture).view;
    const glm::dvec3 right(view[0].x, view[1].x, view[2].x);
    const glm::dvec3 up(view[0].y, view[1].y, view[2].y);
    ViewCamera camera = picture.camera;
    const auto distance = [](const ciel::Vec3d& a, const ciel::Vec3d& b) {
        return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    };
    const double height =
        camera.parallel ? camera.parallel_height
                        : 2 * distance(camera.position, camera.target) * std::tan(glm::radians(camera.fov_degrees) / 2);
    const glm::dvec3 shift = height * picture.width / picture.height * (to_left * right + down * up);
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        camera.position[at] += shift[k];
        camera.target[at] += shift[k];
    }
    return camera;
}

// For narrow pictures, in which legends extend past the middle. Puts the scene beside or below all annotations.
std::optional<ViewCamera> clear_aside(AnnotatedPicture picture, const std::vector<glm::dvec3>& points,
                                      const Layout& layout) {
    constexpr double large_step = 1.1, furthest_aside = 3;
    double away = 1;
    while (away < furthest_aside) {
        for (int i = 1; i <= most_aside; ++i)
            for (const auto& [to_left, down] : {std::pair(1, 0), {0, 1}, {0, 2}}) {
                AnnotatedPicture moved = picture;
                moved.camera = stepped_aside(picture, i * to_left * aside, i * down * aside);
                if (is_clear(moved, points, layout)) return moved.camera;
            }
        away *= large_step;
        step_back(picture.camera, large_step);
    }
    return {};
}

} // namespace

ViewCamera clear_of_annotations(const AnnotatedPicture& picture, TextMeasure& text) {
    if (picture.annotations.empty()) return picture.camera;
    AnnotatedPicture judged = picture;
    if (!Layout(picture, text).has_smallest_text()) { // text scales with the picture, so a test at one size is enough
        judged.width = std::max(
            1, static_cast<int>(std::lround(static_cast<double>(picture.width) / picture.height * usual_height)));
        judged.height = usual_height;
    }
    Layout layout(judged, text);
    lay_title(layout, judged.annotations);
    lay_captions(layout, judged.annotations);
    lay_legends(layout, judged.annotations);
    if (judged.annotations.triad) lay_triad(layout, judged);
    const std::vector<glm::dvec3> points = points_of_edges(judged);
    double away = 1;
    while (away < furthest) {
        if (is_clear(judged, points, layout)) return judged.camera;
        away *= step;
        step_back(judged.camera);
    }
    judged.camera = picture.camera;
    return clear_aside(judged, points, layout).value_or(picture.camera);
}

} // namespace server::annotations
