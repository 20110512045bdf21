// Section 2.1 of the paper: a slice is the iso-surface of the distance to a plane.
#include "ciel/field.hpp"
#include "ciel/parallel.hpp"

namespace ciel {

std::vector<float> plane_distance(const FaceMeshView& mesh, Vec3d origin, Vec3d normal) {
    std::vector<float> out(mesh.vertex_count());
    double shift = 0; // distance from the plane to mesh.origin; double, because both origins may be large
    for (std::size_t i = 0; i < 3; ++i) shift += normal[i] * (mesh.origin[i] - origin[i]);
    parallel_for(out.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const float* p = &mesh.positions[3 * v];
            out[v] = static_cast<float>(normal[0] * p[0] + normal[1] * p[1] + normal[2] * p[2] + shift);
        }
    });
    return out;
}

} // namespace ciel
