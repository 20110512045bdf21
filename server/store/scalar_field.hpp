// ScalarField: a scalar of a dataset on the mesh of a step. Makes surfaces, slices and gradients, so that the libraries
// above the store need no positions and no face lists.
#pragma once

#include "ciel/sweep_sinks.hpp"
#include "ciel/threshold_surface.hpp"
#include "store/dataset.hpp"

namespace server::store {

// Keeps all data alive that its members refer to. Functions that need faces read and check the faces at the first call
// for the mesh. Positions are loaded as in MeshArrays::points_to_load.
struct ScalarField {
    std::shared_ptr<const ciel::Topology> topology;
    std::shared_ptr<const ciel::Field> field;
    std::shared_ptr<const Dataset> dataset;
    std::size_t step = 0;

    ScalarField() = default;
    // `of_points`: the positions, without faces.
    ScalarField(std::shared_ptr<const ciel::Topology> of_mesh, std::shared_ptr<const ciel::Field> of_values,
                ciel::FaceMeshView of_points, std::shared_ptr<const Dataset> of_dataset, std::size_t at_step);

    // Surfaces store positions as float offsets from the surface origin, which is near the mesh.
    [[nodiscard]] const ciel::Vec3d& surface_origin() const { return points_.surface_origin; }
    void set_surface_origin(const ciel::Vec3d& origin) { points_.surface_origin = origin; }
    [[nodiscard]] bool has_double_positions() const { return points_.positions.has_doubles(); }

    // Returns a Query with the positions and the field.
    [[nodiscard]] ciel::Query query(ciel::Extraction extraction = {}) const;
    // Sets the positions and the field of a Query on the same topology.
    void set_in(ciel::Query& query) const;
    // Cuts all values in one pass and sets out[i] to the sink's result for values[i] (sweep in ciel/sweep_sinks.hpp).
    // Returns false when `stop` was requested.
    template <class Sink>
    bool sweep(std::span<const double> values, const Sink& sink, std::vector<typename Sink::Out>& out,
               const ciel::StopToken& stop, ciel::Extraction extraction) const {
        return ciel::sweep(*topology, points_, *field, values, sink, out, stop, extraction);
    }
    // Returns the gradient of `values` at each vertex (vertex_gradients in ciel/field.hpp).
    [[nodiscard]] std::vector<ciel::Vec3f> gradients(ciel::ValuesView values) const;
    // Returns the surface around the kept cells (threshold_surface in ciel/threshold_surface.hpp). `kept`: one flag for
    // each cell.
    [[nodiscard]] ciel::Surface surface_around(std::span<const std::uint8_t> kept, const ciel::BlockBoxes& boxes,
                                               ciel::CollapsedFaces collapsed) const;
    // Returns the boundary faces at which the field differs from `level` by at most `tolerance` (boundary_faces_at in
    // ciel/mesh_faces.hpp).
    [[nodiscard]] ciel::Surface boundary_at(double level, double tolerance) const;

private:
    [[nodiscard]] ciel::FaceMeshView boundary() const;

    ciel::FaceMeshView points_;
};

} // namespace server::store
