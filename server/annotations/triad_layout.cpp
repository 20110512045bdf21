// Draws arrows along x, y and z at the lower left, in the colors of the web client.
#include "annotations/camera.hpp"
#include "annotations/layout.hpp"

#include <algorithm>
#include <cmath>

namespace server::annotations {
namespace {

constexpr double arm = 2.2, reach = 3.4; // ems from the center to the arrow tips and to the outer sides of the letters
constexpr std::array<Ink, 3> inks{
    {{0.878F, 0.376F, 0.353F, 1}, {0.310F, 0.682F, 0.384F, 1}, {0.357F, 0.561F, 0.910F, 1}}};
constexpr std::array names{"x", "y", "z"};

struct Arm {
    std::size_t axis = 0;
    double x = 0, y = 0, nearness = 0; // unit vector of the axis: components to the right, down, and towards the eye
};

std::array<Arm, 3> arms_of(const AnnotatedPicture& picture) {
    const glm::dmat4 view = view_transform(picture).view;
    std::array<Arm, 3> arms;
    for (int axis = 0; axis < 3; ++axis)
        arms[static_cast<std::size_t>(axis)] = {static_cast<std::size_t>(axis), view[axis].x, -view[axis].y,
                                                view[axis].z};
    std::sort(arms.begin(), arms.end(), [](const Arm& a, const Arm& b) { return a.nearness < b.nearness; });
    return arms;
}

void draw_arm(Layout& layout, const Arm& one, PicturePoint center) {
    const double em = layout.em();
    const double length = std::hypot(one.x, one.y);
    const Ink& ink = inks[one.axis];
    const PicturePoint tip{center.x + arm * em * one.x, center.y + arm * em * one.y};
    const double head = std::min(0.55 * em, 0.7 * arm * em * length); // an arrow along the view direction has no head
    if (head > 0.5) {
        const PicturePoint along{one.x / length, one.y / length};
        const PicturePoint root{tip.x - head * along.x, tip.y - head * along.y};
        const double half = 0.36 * head;
        layout.overlay.strokes.push_back({center, root, 1.6 * layout.stroke_width(), ink});
        layout.overlay.triangles.push_back({{tip, PicturePoint{root.x - half * along.y, root.y + half * along.x},
                                             PicturePoint{root.x + half * along.y, root.y - half * along.x}},
                                            ink});
    }
    const TextSize& size = layout.text();
    const std::string name = names[one.axis];
    const double x = center.x + (arm + 0.55) * em * one.x - layout.width_of(name, size) / 2.0;
    const double y = center.y + (arm + 0.55) * em * one.y + 0.27 * em; // half the height of a small letter
    layout.write(name, size, static_cast<int>(std::lround(x)), static_cast<int>(std::lround(y)), ink);
}

} // namespace

void lay_triad(Layout& layout, const AnnotatedPicture& picture) {
    const double side = 2 * reach * layout.em();
    const Box box{layout.room.left, layout.room.bottom - side, layout.room.left + side, layout.room.bottom};
    const bool is_small = side <= 0.5 * layout.width() && side <= 0.5 * layout.height();
    if (!is_small || !layout.is_free(box)) return;
    layout.take(box);
    layout.back({box.left + layout.em(), box.top + layout.em(), box.right - layout.em(), box.bottom - layout.em()});
    const PicturePoint center{(box.left + box.right) / 2, (box.top + box.bottom) / 2};
    for (const Arm& one : arms_of(picture)) draw_arm(layout, one, center);
}

} // namespace server::annotations
