// ScalarField: a scalar of a dataset on the mesh of a step. Makes surfaces, slices and gradients, so that rooms above
// the store need no positions and no face lists.
#pragma once

#include "ciel/sweep_sinks.hpp"
#include "ciel/threshold_surface.hpp"
#include "store/dataset.hpp"

namespace ciel::store {

// Keeps all data alive that its members refer to. Functions that need faces read and check the faces at the first call
// for the mesh. Positions are loaded as in MeshArrays::points_to_load.
struct ScalarField {
    std::shared_ptr<const Topology> topology;
    std::shared_ptr<const Field> field;
    std::shared_ptr<const Dataset> dataset;
    std::size_t step = 0;

    ScalarField() = default;
    // `of_points`: the positions, without faces.
    ScalarField(std::shared_ptr<const Topology> of_mesh, std::shared_ptr<const Field> of_values, FaceMeshView of_points,
                std::shared_ptr<const Dataset> of_dataset, std::size_t at_step);

    // Surfaces store positions as float offsets from the surface origin, which is near the mesh.
    [[nodiscard]] const Vec3d& surface_origin() const { return points_.surface_origin; }
    void set_surface_origin(const Vec3d& origin) { points_.surface_origin = origin; }
    [[nodiscard]] bool has_double_positions() const { return points_.positions.has_doubles(); }

    // The field is set. This object or a copy must outlive the Query.
    [[nodiscard]] Query query(Extraction extraction = {}) const;
    // Sets the positions and the field of a Query on the same topology. This object or a copy must outlive the Query.
    void set_in(Query& query) const;
    // Cuts all values in one pass and sets out[i] to the sink's result for values[i] (sweep in ciel/sweep_sinks.hpp).
    // Returns false when `stop` was requested.
    template <class Sink>
    bool sweep(std::span<const double> values, const Sink& sink, std::vector<typename Sink::Out>& out,
               const StopToken& stop, Extraction extraction) const {
        return ciel::sweep(*topology, points_, *field, values, sink, out, stop, extraction);
    }
    // Returns the gradient of `values` at each vertex (vertex_gradients in ciel/field.hpp).
    [[nodiscard]] std::vector<Vec3f> gradients(ValuesView values) const;
    // Returns the surface around the kept cells (threshold_surface in ciel/threshold_surface.hpp). `kept`: one flag for
    // each cell.
    [[nodiscard]] Surface surface_around(std::span<const std::uint8_t> kept, const BlockBoxes& boxes,
                                         CollapsedFaces collapsed) const;
    // Returns the boundary faces at which the field differs from `level` by at most `tolerance` (boundary_faces_at in
    // ciel/mesh_faces.hpp).
    [[nodiscard]] Surface boundary_at(double level, double tolerance) const;

private:
    [[nodiscard]] FaceMeshView boundary() const;

    FaceMeshView points_;
};

} // namespace ciel::store
