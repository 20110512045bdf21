#include "ciel/contour.hpp"

#include "ciel/parallel.hpp"
#include "ciel/point_interpolation.hpp"
#include "ciel/threshold_surface.hpp"
#include "fields/field_data.hpp"
#include "fields/stored_values.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace ciel {

using detail::PerItem;
using detail::StoredValues;

namespace {

void name_as_given(const Mesh& mesh, std::span<EdgePoint> points, std::span<Index> cells) {
    const std::span<const Index> vertex = mesh.original_vertex(), cell = mesh.original_cell();
    if (!vertex.empty())
        for (EdgePoint& point : points) {
            point.a = vertex[point.a];
            point.b = vertex[point.b];
        }
    if (!cell.empty())
        for (Index& id : cells) id = cell[id];
}

void name_as_given(const Mesh& mesh, Surface& surface) { name_as_given(mesh, surface.points, surface.polygon_cell); }

// A cut of a sweep, copied to replace stored ids by the caller's ids.
class NamedCut {
public:
    NamedCut(const Mesh& mesh, const BlockPolygons& cut)
        : points_(cut.points.begin(), cut.points.end()), cells_(cut.polygon_cell.begin(), cut.polygon_cell.end()),
          cut_(cut) {
        for (Index& cell : cells_) cell += cut.cell_begin;
        name_as_given(mesh, points_, cells_);
        cut_.points = points_;
        cut_.polygon_cell = cells_;
        cut_.cell_begin = 0;
    }
    NamedCut(const NamedCut&) = delete;
    NamedCut& operator=(const NamedCut&) = delete;

    [[nodiscard]] const BlockPolygons& get() const { return cut_; }

private:
    std::vector<EdgePoint> points_;
    std::vector<Index> cells_;
    BlockPolygons cut_;
};

const Mesh& mesh_of(const Field& field) {
    const Mesh* mesh = field.mesh();
    if (mesh == nullptr)
        fail("the field was not made from a Mesh; make the field from a Mesh, so that results can have the caller's "
             "ids");
    return *mesh;
}

// Returns one row for each point of the mesh, in the caller's order: the mean of the cells around the point.
std::vector<double> at_points(const Mesh& mesh, const ArrayView& of_cells) {
    const std::span<const Index> vertex = mesh.original_vertex();
    const std::size_t width = of_cells.columns();
    const PointInterpolation points(mesh.topology(), mesh.stored());
    std::vector<double> out(mesh.point_count() * width, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t c = 0; c < width; ++c)
        StoredValues(mesh, of_cells.column(c), PerItem::cell).with([&]<class T>(const std::vector<T>& cells) {
            const std::vector<T> found = points.apply(std::span<const T>(cells), 1);
            for (std::size_t i = 0; i < found.size(); ++i) out[(vertex.empty() ? i : vertex[i]) * width + c] = found[i];
        });
    return out;
}

} // namespace

struct Contour::State {
    Field field;
    bool normals;
    unsigned threads;
    Query query;
};

Contour::Contour(const Field& field, const Options& options)
    : state_(std::make_unique<State>(
          State{field, options.normals.has_value(), options.threads,
                Query(mesh_of(field).topology(), mesh_of(field).stored(), {options.algorithm, options.decider})})) {
    if (options.normals) state_->query.set_normals(*options.normals);
    with_threads(options.threads, [&] { state_->query.set_field(state_->field); });
    if (options.blocks) state_->query.set_blocks(*options.blocks);
}

Contour::~Contour() = default;
Contour::Contour(Contour&&) noexcept = default;
Contour& Contour::operator=(Contour&&) noexcept = default;

void Contour::set(const Field& field) {
    if (&mesh_of(field).topology() != &mesh_of(state_->field).topology())
        fail("a Contour takes only fields of the mesh that it was made with; make another Contour for another mesh");
    state_->query.set_mesh(mesh_of(field).stored());
    with_threads(state_->threads, [&] { state_->query.set_field(field); });
    state_->field = field;
}

bool Contour::at(double level, Surface& out, const StopToken& stop) {
    bool done = false;
    with_threads(state_->threads, [&] { done = state_->query.extract(level, state_->normals, out, stop); });
    if (done) name_as_given(mesh_of(state_->field), out);
    return done;
}

std::size_t Contour::memory_bytes() const { return state_->query.memory_bytes(); }

Surface contour(const Mesh& mesh, const ArrayView& values, double level, const Options& options) {
    return std::move(contour(mesh, values, std::span(&level, 1), options).front());
}

std::vector<Surface> contour(const Mesh& mesh, const ArrayView& values, std::span<const double> levels,
                             const Options& options) {
    std::vector<Surface> surfaces(levels.size());
    with_threads(options.threads, [&] {
        Contour contour(Field(mesh, values), options);
        for (std::size_t i = 0; i < levels.size(); ++i) contour.at(levels[i], surfaces[i]);
    });
    return surfaces;
}

Surface slice(const Mesh& mesh, const Vec3d& origin, const Vec3d& normal, const Options& options) {
    const double length = std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    if (!(length > 0) || !std::isfinite(length))
        fail("a slice needs a normal whose length is finite and not zero; give another normal");
    Surface surface;
    with_threads(options.threads, [&] {
        Contour(Field::plane(mesh, origin, {normal[0] / length, normal[1] / length, normal[2] / length}), options)
            .at(0, surface);
    });
    return surface;
}

bool sweep(const Field& field, std::span<const double> levels, const OnCut& on_cut, const Options& options,
           const StopToken& stop) {
    if (options.blocks) fail("a sweep cuts all blocks; leave Options::blocks out and choose blocks in the callback");
    const Mesh& mesh = mesh_of(field);
    const OnCut named = [&](std::size_t value, Index block, const BlockPolygons& cut) {
        on_cut(value, block, NamedCut(mesh, cut).get());
    };
    bool done = false;
    // Always sets a thread limit, so that a loop that a callback starts runs on the callback's thread only. Otherwise
    // this thread could take another block while it waits for that loop, and overwrite the cut that the callback reads.
    with_threads(options.threads > 0 ? options.threads : thread_count(), [&] {
        SweepScratch scratch;
        done = sweep(mesh.topology(), mesh.stored(), field, levels, named, scratch, stop,
                     {options.algorithm, options.decider});
    });
    return done;
}

bool sweep(const Mesh& mesh, const ArrayView& values, std::span<const double> levels, const OnCut& on_cut,
           const Options& options, const StopToken& stop) {
    bool done = false;
    with_threads(options.threads, [&] { done = sweep(Field(mesh, values), levels, on_cut, options, stop); });
    return done;
}

ClippedSurface clip(const Surface& surface, const Mesh& mesh, const ArrayView& values,
                    std::span<const HalfSpace> planes, double slack) {
    std::vector<double> at_surface;
    if (!values.empty()) at_surface = interpolate(surface, mesh, values);
    // The planes relative to surface_origin, because surface.positions are relative to it.
    std::vector<HalfSpace> shifted(planes.begin(), planes.end());
    for (HalfSpace& plane : shifted)
        for (std::size_t axis = 0; axis < 3; ++axis)
            plane.offset += plane.normal[axis] * mesh.stored().surface_origin[axis];
    return clip_surface(surface, at_surface, shifted, slack);
}

std::vector<double> interpolate(const Surface& surface, const Mesh& mesh, const ArrayView& values, bool of_cells) {
    if (surface.points.size() < surface.positions.size())
        fail("a clipped surface has points that lie on no edge of the mesh; interpolate before clipping, or pass the "
             "values to clip");
    if (values.columns() == 0) fail("values to interpolate have no columns; give at least one column");
    if (of_cells) return interpolate(surface, mesh, {at_points(mesh, values), values.columns()});
    if (values.rows() != mesh.point_count())
        fail("values to interpolate must have one row for each point of the mesh (" +
             std::to_string(mesh.point_count()) + " rows), not " + std::to_string(values.rows()));
    std::vector<double> out;
    out.reserve(surface.points.size() * values.columns());
    for (const EdgePoint& point : surface.points) {
        if (std::max(point.a, point.b) >= values.rows())
            fail("the surface uses the point " + std::to_string(std::max(point.a, point.b)) +
                 ", but the mesh has only " + std::to_string(values.rows()) +
                 " points; pass the mesh from which the surface was made");
        for (std::size_t c = 0; c < values.columns(); ++c)
            out.push_back(lerp(values.real(point.a, c), values.real(point.b, c), point.t));
    }
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
