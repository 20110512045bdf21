#include "ciel/contour.hpp"

#include "ciel/threshold_surface.hpp"
#include "fields/field_data.hpp"
#include "fields/stored_values.hpp"

#include <cmath>
#include <string>

namespace ciel {
namespace {

// Replaces vertex and cell ids of the stored mesh by the caller's ids.
void name_as_given(const Mesh& mesh, Surface& surface) {
    const std::span<const Index> vertex = mesh.original_vertex(), cell = mesh.original_cell();
    if (!vertex.empty())
        for (EdgePoint& point : surface.points) {
            point.a = vertex[point.a];
            point.b = vertex[point.b];
        }
    if (!cell.empty())
        for (Index& id : surface.polygon_cell) id = cell[id];
}

const Mesh& mesh_of(const Field& field) {
    const Mesh* mesh = field.mesh();
    if (mesh == nullptr) fail("a Contour needs a field that was made from a Mesh");
    return *mesh;
}

} // namespace

struct Contour::State {
    Field field;
    bool normals;
    Query query;
};

Contour::Contour(const Field& field, const Options& options)
    : state_(std::make_unique<State>(
          State{field, options.normals.has_value(),
                Query(mesh_of(field).topology(), mesh_of(field).stored(), {options.algorithm, options.decider})})) {
    if (options.normals) state_->query.set_normals(*options.normals);
    state_->query.set_field(state_->field);
}

Contour::~Contour() = default;
Contour::Contour(Contour&&) noexcept = default;
Contour& Contour::operator=(Contour&&) noexcept = default;

void Contour::set(const Field& field) {
    if (&mesh_of(field).topology() != &mesh_of(state_->field).topology())
        fail("a Contour takes only fields of the mesh that it was made with; make another Contour for another mesh");
    state_->query.set_mesh(mesh_of(field).stored());
    state_->query.set_field(field);
    state_->field = field;
}

bool Contour::at(double level, Surface& out, const StopToken& stop) {
    if (!state_->query.extract(level, state_->normals, out, stop)) return false;
    name_as_given(mesh_of(state_->field), out);
    return true;
}

std::size_t Contour::memory_bytes() const { return state_->query.memory_bytes(); }

Surface contour(const Mesh& mesh, const ArrayView& values, double level, const Options& options) {
    Surface surface;
    Contour(Field(mesh, values), options).at(level, surface);
    return surface;
}

std::vector<Surface> contour(const Mesh& mesh, const ArrayView& values, std::span<const double> levels,
                             const Options& options) {
    Contour contour(Field(mesh, values), options);
    std::vector<Surface> surfaces(levels.size());
    for (std::size_t i = 0; i < levels.size(); ++i) contour.at(levels[i], surfaces[i]);
    return surfaces;
}

Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options) {
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 0) || !std::isfinite(length)) fail("a slice needs a normal of finite length, not zero");
    Surface surface;
    Contour(Field::plane(mesh, origin, {normal[0] / length, normal[1] / length, normal[2] / length}), options)
        .at(0, surface);
    return surface;
}

std::vector<double> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values) {
    if (values.rows() != mesh.point_count())
        fail("values to interpolate must be one row per point of the mesh (" + std::to_string(mesh.point_count()) +
             "), not " + std::to_string(values.rows()));
    std::vector<double> out;
    out.reserve(surface.points.size() * values.columns());
    for (const EdgePoint& point : surface.points)
        for (std::size_t c = 0; c < values.columns(); ++c)
            out.push_back(lerp(values.real(point.a, c), values.real(point.b, c), point.t));
    return out;
}

std::vector<Vec3f> gradients(const Mesh& mesh, const ArrayView& values) {
    const StoredValues stored(mesh, values, PerItem::point);
    std::vector<Vec3f> of_stored = vertex_gradients(mesh.topology(), mesh.stored(), stored.view());
    const std::span<const Index> vertex = mesh.original_vertex();
    if (vertex.empty()) return of_stored;
    std::vector<Vec3f> out(mesh.point_count());
    for (std::size_t i = 0; i < vertex.size(); ++i) out[vertex[i]] = of_stored[i];
    return out;
}

Surface threshold(const Mesh& mesh, const ArrayView& values, std::array<double, 2> range, bool of_cells) {
    const StoredValues stored(mesh, values, of_cells ? PerItem::cell : PerItem::point);
    const std::vector<std::uint8_t> kept = of_cells ? cells_in_range(stored.view(), range)
                                                    : cells_in_range(mesh.stored(), stored.view(), range, InRange::all);
    Surface surface = threshold_surface(mesh.stored(), kept);
    name_as_given(mesh, surface);
    return surface;
}

} // namespace ciel
