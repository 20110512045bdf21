#include "store/scalar_field.hpp"

#include "ciel/mesh_faces.hpp"
#include "store/mesh_arrays.hpp"

namespace server::store {

ScalarField::ScalarField(std::shared_ptr<const ciel::Topology> of_mesh, std::shared_ptr<const ciel::Field> of_values,
                         ciel::FaceMeshView of_points, std::shared_ptr<const Dataset> of_dataset, std::size_t at_step)
    : topology(std::move(of_mesh)), field(std::move(of_values)), dataset(std::move(of_dataset)), step(at_step),
      points_(std::move(of_points)) {}

ciel::Query ScalarField::query(ciel::Extraction extraction) const {
    ciel::Query made(*topology, points_, extraction);
    made.set_field(*field);
    return made;
}

void ScalarField::set_in(ciel::Query& query) const {
    query.set_mesh(points_);
    query.set_field(*field);
}

std::vector<ciel::Vec3f> ScalarField::gradients(ciel::ValuesView values) const {
    return ciel::vertex_gradients(*topology, points_, values);
}

ciel::Surface ScalarField::surface_around(std::span<const std::uint8_t> kept, const ciel::BlockBoxes& boxes,
                                          ciel::CollapsedFaces collapsed) const {
    return ciel::threshold_surface(*topology, boundary(), boxes, kept, collapsed);
}

ciel::Surface ScalarField::boundary_at(double level, double tolerance) const {
    const ciel::FaceMeshView faces = boundary();
    return ciel::face_surface(faces, ciel::boundary_faces_at(faces, *field, level, tolerance));
}

ciel::FaceMeshView ScalarField::boundary() const {
    const Step& at = dataset->steps()[step];
    ciel::FaceMeshView boundary = dataset->mesh_arrays().boundary(at.mesh, at.coordinates);
    boundary.surface_origin = points_.surface_origin;
    return boundary;
}

} // namespace server::store
