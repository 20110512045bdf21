#include "ciel/clip_surface.hpp"
#include "ciel/contour_lines.hpp"
#include "ciel/feature_edges.hpp"
#include "ciel/polygon_edges.hpp"
#include "ciel/threshold_surface.hpp"
#include "support/kept.hpp"
#include "wasm/results.hpp"

namespace ciel::test {
namespace {

std::vector<HalfSpace> half_spaces(const FaceMeshView& mesh, const FieldPair& fields) {
    HalfSpace half{fields.slice_normal, 0};
    for (std::size_t d = 0; d < 3; ++d) half.offset -= half.normal[d] * (fields.slice_origin[d] - mesh.origin[d]);
    HalfSpace across{{half.normal[1], -half.normal[0], 0.25}, 0};
    for (std::size_t d = 0; d < 3; ++d) across.offset -= across.normal[d] * (fields.slice_origin[d] - mesh.origin[d]);
    return {half, across};
}

// The middle half of the field's range; an empty range for a field without values.
std::array<double, 2> middle_range(const Meshes& meshes, std::span<const float> values) {
    const auto [low, high] = Field(meshes.topology, values, kept_by_test).range();
    const double quarter = (static_cast<double>(high) - low) / 4;
    return {low + quarter, high - quarter};
}

} // namespace

void record_selections(const Meshes& meshes, const FieldPair& fields, Results& results) {
    const FaceMeshView mesh = meshes.view();
    const auto range = middle_range(meshes, fields.others);
    const auto all = cells_in_range(mesh, fields.others, range, InRange::all);
    const auto any = cells_in_range(mesh, fields.others, range, InRange::any);
    results.record(fields.where, "threshold, all", all);
    results.record(fields.where, "threshold, any", any);
    results.record(fields.where + " / around all", threshold_surface(mesh, all));
    results.record(fields.where + " / around any", threshold_surface(mesh, any));

    const Field field(meshes.topology, fields.values, kept_by_test);
    Query query(meshes.topology, kept(mesh));
    query.set_field(field);
    Surface surface;
    for (double nu : fields.walk) {
        const std::string where = fields.where + " / surface at " + std::to_string(nu);
        query.extract(nu, true, surface);
        std::vector<float> at_points(surface.points.size());
        interpolate(surface.points, fields.others, 1, at_points);
        results.record(where, "edges", polygon_edges(surface));
        results.record(where, "feature edges", feature_edges(surface, 30));
        results.record(where, "contour lines", contour_lines(surface, at_points, fields.other_walk));
        results.record(where + " / of any", polygons_of_cells(surface, any));
        const ClippedSurface clipped = clip_surface(surface, at_points, half_spaces(mesh, fields), 1e-6);
        results.record(where + " / clipped", clipped.surface);
        results.record(where, "clipped values", clipped.values);
    }
}

} // namespace ciel::test
