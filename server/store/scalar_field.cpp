#include "store/scalar_field.hpp"

#include "ciel/mesh_faces.hpp"
#include "store/mesh_arrays.hpp"

namespace ciel::store {

ScalarField::ScalarField(std::shared_ptr<const Topology> of_mesh, std::shared_ptr<const Field> of_values,
                         FaceMeshView of_points, std::shared_ptr<const Dataset> of_dataset, std::size_t at_step)
    : topology(std::move(of_mesh)), field(std::move(of_values)), dataset(std::move(of_dataset)), step(at_step),
      points_(std::move(of_points)) {}

Query ScalarField::query(Extraction extraction) const {
    Query made(*topology, points_, extraction);
    made.set_field(*field);
    return made;
}

void ScalarField::set_in(Query& query) const {
    query.set_mesh(points_);
    query.set_field(*field);
}

std::vector<Vec3f> ScalarField::gradients(ValuesView values) const {
    return vertex_gradients(*topology, points_, values);
}

Surface ScalarField::surface_around(std::span<const std::uint8_t> kept, const BlockBoxes& boxes,
                                    CollapsedFaces collapsed) const {
    return threshold_surface(*topology, boundary(), boxes, kept, collapsed);
}

Surface ScalarField::boundary_at(double level, double tolerance) const {
    const FaceMeshView faces = boundary();
    return face_surface(faces, boundary_faces_at(faces, *field, level, tolerance));
}

FaceMeshView ScalarField::boundary() const {
    const Step& at = dataset->steps()[step];
    FaceMeshView boundary = dataset->mesh_arrays().boundary(at.mesh, at.coordinates);
    boundary.surface_origin = points_.surface_origin;
    return boundary;
}

} // namespace ciel::store
