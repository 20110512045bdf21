#include "import/values/patch_weights.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/linear_weights.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace server::importer {

using ciel::operator-;

namespace {

struct Around { // the patch's faces around one vertex
    std::vector<std::size_t> faces;
    ciel::LeftOutDirections normals, borders;
    double area = 0;
};

// No weights can be exact in the directions across the border, because all faces lie on one side of it.
void add_borders(const ciel::FaceMeshView& mesh, const std::vector<ciel::Index>& faces,
                 const std::vector<ciel::Vec3d>& areas, std::map<ciel::Index, Around>& around) {
    struct Side {
        std::size_t face = 0;
        int faces = 0;
    };
    std::map<std::pair<ciel::Index, ciel::Index>, Side> edges;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto loop = mesh.loop(faces[i]);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const ciel::Index a = loop[k], b = loop[(k + 1) % loop.size()];
            Side& side = edges[{std::min(a, b), std::max(a, b)}];
            side.face = i;
            ++side.faces;
        }
    }
    for (const auto& [ends, side] : edges) {
        if (side.faces != 1) continue;
        const ciel::Vec3d along = ciel::position(mesh, ends.second) - ciel::position(mesh, ends.first);
        const ciel::Vec3d across = ciel::cross(along, areas[side.face]);
        around[ends.first].borders.add(across);
        around[ends.second].borders.add(across);
    }
}

} // namespace

PatchWeights weigh_patch(const ciel::FaceMeshView& mesh, const std::vector<ciel::Index>& faces) {
    std::map<ciel::Index, Around> around;
    std::vector<ciel::Vec3d> centers, areas;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto loop = mesh.loop(faces[i]);
        const ciel::FaceShape shape = ciel::face_shape(mesh, loop.unchecked());
        centers.push_back(shape.center);
        areas.push_back(shape.area);
        // Never 0, so that a vertex with only zero-area faces also gets a value.
        const double area = std::max(std::sqrt(ciel::dot(shape.area, shape.area)), std::numeric_limits<double>::min());
        for (const ciel::Index vertex : loop) {
            Around& here = around[vertex];
            if (!here.faces.empty() && here.faces.back() == i) continue; // a face loop may contain a vertex twice
            here.faces.push_back(i);
            here.normals.add(shape.area);
            here.area += area;
        }
    }
    add_borders(mesh, faces, areas, around);

    PatchWeights found;
    std::vector<ciel::Vec3d> displacements;
    std::vector<double> weights;
    for (const auto& [vertex, here] : around) {
        found.vertices.push_back({vertex, here.area, here.normals.directions()});
        ciel::LeftOutDirections all = here.normals;
        for (const ciel::Vec3d& border : here.borders.directions()) all.add(border);
        displacements.clear();
        for (const std::size_t face : here.faces) displacements.push_back(centers[face] - ciel::position(mesh, vertex));
        weights.resize(here.faces.size());
        ciel::linear_weights(displacements, all.directions(), weights);
        for (std::size_t i = 0; i < weights.size(); ++i) found.weights.push_back({vertex, here.faces[i], weights[i]});
    }
    return found;
}

} // namespace server::importer
