#include "annotations/box_edges.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <tuple>

namespace server::annotations {
namespace {

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }

glm::dvec3 corner(const Viewpoint& viewpoint, int axis, bool upper, int second, bool second_upper, int third,
                  bool third_upper) {
    const glm::dvec3 low = vector_of(viewpoint.bounds_min);
    const glm::dvec3 high = vector_of(viewpoint.bounds_max);
    glm::dvec3 point;
    point[axis] = upper ? high[axis] : low[axis];
    point[second] = second_upper ? high[second] : low[second];
    point[third] = third_upper ? high[third] : low[third];
    return point;
}

struct Candidate {
    BoxEdge edge;
    double length = 0; // pixels
    double rank = 0;   // for each axis, the candidate with the largest rank is chosen
};

// Returns the unit vector normal to an edge that points away from the center. `along`: unit vector along the edge.
PicturePoint outward_of(PicturePoint along, PicturePoint middle, PicturePoint center) {
    const PicturePoint across{-along.y, along.x};
    const double side = across.x * (middle.x - center.x) + across.y * (middle.y - center.y);
    return side < 0 ? PicturePoint{-across.x, -across.y} : across;
}

std::optional<Candidate> candidate(const Projection& projection, const Viewpoint& viewpoint, BoxEdge edge) {
    const auto seen = projection.part_seen(edge.low, edge.high);
    if (!seen) return {};
    std::tie(edge.from, edge.to) = *seen;
    const PicturePoint a = projection.pixel(glm::mix(edge.low, edge.high, edge.from));
    const PicturePoint b = projection.pixel(glm::mix(edge.low, edge.high, edge.to));
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    if (!(length > 0)) return {};
    const PicturePoint along{(b.x - a.x) / length, (b.y - a.y) / length};
    const PicturePoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const glm::dvec3 center = (vector_of(viewpoint.bounds_min) + vector_of(viewpoint.bounds_max)) * 0.5;
    const bool is_ahead = projection.clip(center).w > 0;
    edge.outward =
        outward_of(along, middle,
                   is_ahead ? projection.pixel(center) : PicturePoint{viewpoint.width / 2.0, viewpoint.height / 2.0});
    return Candidate{edge, length, edge.axis == projection.upward_axis() ? -middle.x : middle.y};
}

} // namespace

Projection::Projection(const Viewpoint& viewpoint) : viewpoint_(viewpoint) {
    const ViewTransform transform = view_transform(viewpoint);
    matrix_ = transform.projection * transform.view;
    const glm::dmat4 back = glm::inverse(transform.view);
    eye_ = glm::dvec3(back[3]) + vector_of(viewpoint.origin);
    ahead_ = -glm::dvec3(back[2]);
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(transform.view[axis].y) > std::abs(transform.view[upward_axis_].y)) upward_axis_ = axis;
}

glm::dvec4 Projection::clip(const glm::dvec3& world) const {
    return matrix_ * glm::dvec4(world - vector_of(viewpoint_.origin), 1);
}

PicturePoint Projection::pixel(const glm::dvec3& world) const {
    const glm::dvec4 at = clip(world);
    return {(at.x / at.w + 1) / 2 * viewpoint_.width, (1 - at.y / at.w) / 2 * viewpoint_.height};
}

// Clips the line by the method of Liang and Barsky (1984), in homogeneous coordinates.
std::optional<std::pair<double, double>> Projection::part_seen(const glm::dvec3& a, const glm::dvec3& b) const {
    const glm::dvec4 p = clip(a);
    const glm::dvec4 q = clip(b);
    double from = 0;
    double to = 1;
    for (int plane = 0; plane < 6; ++plane) {
        const int axis = plane / 2;
        const double sign = plane % 2 == 0 ? 1 : -1;
        const double in_p = p.w + sign * p[axis]; // negative if p is outside the plane
        const double in_q = q.w + sign * q[axis];
        if (in_p < 0 && in_q < 0) return {};
        if (in_p < 0) from = std::max(from, in_p / (in_p - in_q));
        if (in_q < 0) to = std::min(to, in_p / (in_p - in_q));
    }
    if (!(from < to)) return {};
    return std::pair(from, to);
}

bool Projection::sees_face(int axis, bool upper) const {
    const double side = upper ? 1 : -1;
    if (viewpoint_.camera.parallel) return side * ahead_[axis] < 0;
    const double face = upper ? vector_of(viewpoint_.bounds_max)[axis] : vector_of(viewpoint_.bounds_min)[axis];
    return side * (eye_[axis] - face) > 0;
}

std::vector<BoxEdge> axis_edges(const Viewpoint& viewpoint, double least) {
    const Projection projection(viewpoint);
    std::vector<BoxEdge> edges;
    for (int axis = 0; axis < 3; ++axis) {
        const int second = (axis + 1) % 3;
        const int third = (axis + 2) % 3;
        std::optional<Candidate> best;
        for (const bool second_upper : {false, true})
            for (const bool third_upper : {false, true}) {
                if (projection.sees_face(second, second_upper) == projection.sees_face(third, third_upper)) continue;
                BoxEdge edge;
                edge.axis = axis;
                edge.low = corner(viewpoint, axis, false, second, second_upper, third, third_upper);
                edge.high = corner(viewpoint, axis, true, second, second_upper, third, third_upper);
                const auto found = candidate(projection, viewpoint, edge);
                if (found && found->length >= least && (!best || found->rank > best->rank)) best = found;
            }
        if (best) edges.push_back(best->edge);
    }
    return edges;
}

} // namespace server::annotations
