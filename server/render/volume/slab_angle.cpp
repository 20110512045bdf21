#include "render/volume/slab_angle.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>

namespace server::render {
namespace {

using Corners = std::array<glm::dvec3, 8>;

glm::dvec3 vector_of(const ciel::Vec3d& v) { return {v[0], v[1], v[2]}; }

// Returns the largest tangent of the angle between a ray and `normal`. Returns infinity unless all rays are on the same
// side of the plane through the eye with this normal.
double widest_tangent(const glm::dvec3& normal, const Corners& rays) {
    double widest = 0;
    for (const glm::dvec3& ray : rays) {
        const double ahead = glm::dot(normal, ray) * (glm::dot(normal, rays[0]) < 0 ? -1 : 1);
        if (!(ahead > 0)) return std::numeric_limits<double>::infinity();
        widest = std::max(widest, glm::length(glm::cross(normal, ray)) / ahead);
    }
    return widest;
}

} // namespace

double slab_angle(const VolumeView& view, const ciel::Vec3d& normal) {
    const glm::dmat4 eye = glm::inverse(view.transform->view);
    const glm::dvec2 corner = view.rays_of_pixels().corner;
    const glm::dvec3 low = vector_of(view.low), high = vector_of(view.high);
    Corners picture{}, box{};
    for (std::size_t i = 0; i < picture.size(); ++i) {
        const glm::dvec3 side((i & 1U) != 0 ? 1 : -1, (i & 2U) != 0 ? 1 : -1, (i & 4U) != 0 ? 1 : -1);
        picture[i] = glm::dmat3(eye) * glm::dvec3(side.x * corner.x, side.y * corner.y, -1);
        box[i] = 0.5 * (low + high + side * (high - low)) - glm::dvec3(eye[3]);
    }
    const double widest = widest_tangent(vector_of(normal), picture);
    return view.frame->camera.parallel ? widest : std::min(widest, widest_tangent(vector_of(normal), box));
}

} // namespace server::render
