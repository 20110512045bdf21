#include "import/values/patch_weights.hpp"

#include "ciel/cell_geometry.hpp"
#include "ciel/linear_weights.hpp"
#include "ciel/vector_operators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace ciel::importer {

namespace {

struct Around { // the patch's faces around one vertex
    std::vector<std::size_t> faces;
    LeftOutDirections normals, borders;
    double area = 0;
};

// At the border all faces lie on one side, so that no weights can be exact across the border.
void add_borders(const FaceMeshView& mesh, const std::vector<Index>& faces, const std::vector<Vec3d>& areas,
                 std::map<Index, Around>& around) {
    struct Side {
        std::size_t face = 0;
        int faces = 0;
    };
    std::map<std::pair<Index, Index>, Side> edges;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto loop = mesh.loop(faces[i]);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Index a = loop[k], b = loop[(k + 1) % loop.size()];
            Side& side = edges[{std::min(a, b), std::max(a, b)}];
            side.face = i;
            ++side.faces;
        }
    }
    for (const auto& [ends, side] : edges) {
        if (side.faces != 1) continue;
        const Vec3d along = position(mesh, ends.second) - position(mesh, ends.first);
        const Vec3d across = cross(along, areas[side.face]);
        around[ends.first].borders.add(across);
        around[ends.second].borders.add(across);
    }
}

} // namespace

PatchWeights weigh_patch(const FaceMeshView& mesh, const std::vector<Index>& faces) {
    std::map<Index, Around> around;
    std::vector<Vec3d> centres, areas;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto loop = mesh.loop(faces[i]);
        const FaceShape shape = face_shape(mesh, loop.unchecked());
        centres.push_back(shape.centre);
        areas.push_back(shape.area);
        // Never 0, so that a vertex with only zero-area faces also gets a value.
        const double area = std::max(std::sqrt(dot(shape.area, shape.area)), std::numeric_limits<double>::min());
        for (const Index vertex : loop) {
            Around& here = around[vertex];
            if (!here.faces.empty() && here.faces.back() == i) continue; // a face loop may contain a vertex twice
            here.faces.push_back(i);
            here.normals.add(shape.area);
            here.area += area;
        }
    }
    add_borders(mesh, faces, areas, around);

    PatchWeights found;
    std::vector<Vec3d> displacements;
    std::vector<double> weights;
    for (const auto& [vertex, here] : around) {
        found.vertices.push_back({vertex, here.area, here.normals.directions()});
        LeftOutDirections all = here.normals;
        for (const Vec3d& border : here.borders.directions()) all.add(border);
        displacements.clear();
        for (const std::size_t face : here.faces) displacements.push_back(centres[face] - position(mesh, vertex));
        weights.resize(here.faces.size());
        linear_weights(displacements, all.directions(), weights);
        for (std::size_t i = 0; i < weights.size(); ++i) found.weights.push_back({vertex, here.faces[i], weights[i]});
    }
    return found;
}

} // namespace ciel::importer
