#include "store/mesh_questions.hpp"

#include "store/mesh_arrays.hpp"

namespace server::store {

ciel::FacesSize size_of_faces(const Dataset& dataset, const Step& step, const Group& patch) {
    const std::vector<ciel::Index> numbers(patch.ids.begin(), patch.ids.end());
    return ciel::size_of_faces(dataset.mesh_arrays().numbered_faces(step.mesh, step.coordinates), numbers);
}

bool has_face_with(const Dataset& dataset, const Step& step, const Group& patch,
                   std::span<const ciel::Index> vertices) {
    const std::vector<ciel::Index> numbers(patch.ids.begin(), patch.ids.end());
    const ciel::FaceMeshView faces = dataset.mesh_arrays().numbered_faces(step.mesh, step.coordinates);
    return ciel::face_with_vertices(faces, numbers, vertices) != ciel::none;
}

std::vector<ciel::Vec3d> positions_of(const Dataset& dataset, const Step& step,
                                      std::span<const ciel::EdgePoint> points) {
    const ciel::FaceMeshView mesh = dataset.mesh_arrays().points_to_load(step.mesh, step.coordinates);
    std::vector<ciel::Vec3d> places(points.size());
    mesh.positions.with([&](const auto& all) {
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto& [a, b, t] = points[i];
            for (const ciel::Index vertex : {a, b})
                if (mesh.loader != nullptr) mesh.loader->load(vertex, vertex + 1);
            for (std::size_t axis = 0; axis < 3; ++axis)
                places[i][axis] = mesh.origin[axis] + ciel::lerp(double{all[3 * std::size_t{a} + axis]},
                                                                 double{all[3 * std::size_t{b} + axis]}, t);
        }
    });
    return places;
}

std::uint64_t count_ambiguous_faces(const Dataset& dataset, const Step& step, ciel::ValuesView values) {
    const ciel::FaceMeshView boundary = dataset.mesh_arrays().boundary(step.mesh, step.coordinates);
    return ciel::count_ambiguous_faces(dataset.topology(step.mesh), boundary, values);
}

} // namespace server::store
