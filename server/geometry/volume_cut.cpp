#include "geometry/volume_cut.hpp"

#include "color/transfer_table.hpp"
#include "geometry/cut.hpp"
#include "geometry/slab_sink.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace server::geometry {
namespace {

// Number of slices in an interactive picture. Software rendering draws `most_slices` slices of a few thousand triangles
// about ten times a second. A slice of a mesh with more than `usual_vertices` has more triangles, so the mesh gets
// fewer slices. With fewer than `least_slices`, the slabs would be too thick to show the detail of the mesh.
constexpr double most_slices = 24, least_slices = 8, usual_vertices = 200'000;
// If a slab would exceed the optical depth usual_loss, there are up to `times_more` times as many slices, but at most
// `most_of_all`.
constexpr double usual_loss = 0.25, times_more = 2, most_of_all = 96;
// Limits of the number of slices in a still picture. A mesh with fewer vertices than `large_mesh` gets more slices if
// the opacity is steeper than `steep`.
constexpr double fewest_in_all = 200, most_in_all = 1000, large_mesh = 800'000, steep = 10;

double moving_slices(std::size_t vertices, double loss) {
    const double fitting = most_slices * std::cbrt(usual_vertices / static_cast<double>(vertices + 1));
    const double usual = std::clamp(fitting, least_slices, most_slices);
    return std::clamp(loss / usual_loss, usual, std::min(times_more * std::max(fitting, least_slices), most_of_all));
}

ciel::Vec3d unit_vector(const ciel::Vec3d& v) {
    const double length = std::hypot(v[0], v[1], v[2]);
    return length > 0 ? ciel::Vec3d{v[0] / length, v[1] / length, v[2] / length} : ciel::Vec3d{0, 1, 0};
}

} // namespace

std::size_t Slabs::memory_bytes() const {
    std::size_t bytes = 0;
    for (const color::SlabTriangles& slice : slices) bytes += slice.memory_bytes();
    return bytes;
}

std::size_t usual_slices(double length, double mean_edge, std::size_t vertices, double steepest) {
    const double affordable = std::sqrt(large_mesh / static_cast<double>(vertices + 1));
    const double finer = std::clamp(std::min(affordable, steepest / steep), 1.0, 2.0);
    const double fitting = mean_edge > 0 ? finer * fewest_in_all * length / mean_edge : fewest_in_all;
    return static_cast<std::size_t>(std::lround(std::clamp(fitting, fewest_in_all, most_in_all)));
}

double steepness(std::span<const std::array<double, 2>> opacity_points) {
    double steepest = 0;
    for (std::size_t i = 1; i < opacity_points.size(); ++i) {
        const auto& [from, low] = opacity_points[i - 1];
        const auto& [to, high] = opacity_points[i];
        const double rise = std::abs(color::extinction_of(high) - color::extinction_of(low));
        if (rise > 0) steepest = std::max(steepest, rise / (to - from)); // infinite at a step of the opacity
    }
    return steepest;
}

double largest_loss(std::span<const std::array<double, 2>> opacity_points, double unit_length, double length) {
    double opacity = 0;
    for (const auto& [place, of_unit_length] : opacity_points) opacity = std::max(opacity, of_unit_length);
    return color::extinction_of(opacity) * length / unit_length;
}

std::size_t moving_stride(std::size_t slices, std::size_t vertices, double loss) {
    const double fitting = static_cast<double>(slices) / moving_slices(vertices, loss);
    return 2 * static_cast<std::size_t>(std::ceil((fitting - 1) / 2)) + 1; // `fitting` rounded up to an odd number
}

VolumeCut::VolumeCut() : identity(unique_number()) {}

void VolumeCut::use_property(const std::string& name, std::size_t step, store::LoadedDataset& loaded,
                             const ciel::Vec3d& origin) {
    const std::string wanted = std::to_string(step) + " " + name;
    if (key == wanted) return;
    store::ScalarField field = loaded.scalar(name, step); // throws NotWritten before any change
    field.set_surface_origin(origin);
    key.clear();
    slabs = nullptr;
    slabs_key.clear();
    const store::Values stored = loaded.scalar_values(name, step);
    gradients = field.gradients(stored);
    const auto [low, high] = field.field->range();
    value_origin = stored.has_doubles() && low <= high ? low / 2 + high / 2 : 0;
    has_own_values = stored.has_doubles();
    values = has_own_values ? store::Values(ciel::floats_from(value_origin, stored)) : stored;
    const ciel::Topology& topology = *field.topology;
    filled = filled_cells(*field.field);
    if (const auto sound = loaded.sound_cells(name, step))
        for (std::size_t cell = 0; cell < filled.size(); ++cell)
            if (sound->kept[cell] == 0) filled[cell] = 0;
    const ciel::Surface faces = field.surface_around(filled, *loaded.boxes(step), ciel::CollapsedFaces::keep);
    boundary = std::make_shared<const color::SlabTriangles>(
        slab_boundary(faces, {topology, values.floats(), gradients, filled}));
    key = wanted;
}

bool VolumeCut::cut(const std::string& place, const store::ScalarField& planes, ciel::Vec3d normal, std::size_t count,
                    std::size_t every, ciel::Extraction extraction, const std::stop_token& stop) {
    const std::string wanted = place + " " + std::to_string(count);
    const bool same = slabs && slabs_key == wanted;
    if (same && (stride == 1 || stride == every)) return true;
    auto made = std::make_shared<Slabs>();
    const auto [low, high] = planes.field->range();
    made->normal = normal;
    made->first = low;
    made->thickness = (static_cast<double>(high) - static_cast<double>(low)) / static_cast<double>(count);
    made->boundary = boundary;
    made->slices.resize(count);

    std::vector<double> places;
    for (std::size_t i = every / 2; i < count; i += every)
        places.push_back(made->first + (static_cast<double>(i) + 0.5) * made->thickness);
    std::vector<color::SlabTriangles> cuts;
    const SlabSink sink{{*planes.topology, values.floats(), gradients, filled}};
    if (!planes.sweep(places, sink, cuts, stop, extraction)) return false;
    for (std::size_t i = every / 2, k = 0; i < count; i += every, ++k) made->slices[i] = std::move(cuts[k]);
    slabs = std::move(made);
    slabs_key = wanted;
    stride = every;
    revision = unique_number();
    return true;
}

std::size_t VolumeCut::memory_bytes() const {
    return (has_own_values ? values.size_bytes() : 0) + gradients.size() * sizeof(ciel::Vec3f) + filled.size() +
           (boundary ? boundary->memory_bytes() : 0) + (slabs ? slabs->memory_bytes() : 0);
}

scene::VolumeLayer::Direction slab_direction(const scene::CheckedScene& checked) {
    for (const scene::Layer& layer : checked.scene().layers)
        if (const auto* volume = std::get_if<scene::VolumeLayer>(&layer.kind); volume != nullptr && layer.visible)
            return volume->direction;
    return scene::VolumeLayer::Direction::automatic;
}

namespace {

// Returns whether some camera ray is nearly parallel to the slabs. False if the axis is nearest to the viewing
// direction and the field of view is 30 degrees.
bool sees_along_slabs(const ciel::Vec3d& view, std::size_t axis, const annotations::ViewCamera& camera) {
    constexpr double degree = std::numbers::pi / 180, widest = 85 * degree;
    const double corner = camera.parallel ? 0 : std::tan(camera.fov_degrees / 2 * degree) * std::hypot(1.0, 16.0 / 9.0);
    return std::acos(std::min(std::abs(unit_vector(view)[axis]), 1.0)) + std::atan(corner) > widest;
}

std::optional<std::size_t> axis_of(scene::VolumeLayer::Direction direction) {
    using Direction = scene::VolumeLayer::Direction;
    if (direction == Direction::automatic || direction == Direction::screen) return {};
    return static_cast<std::size_t>(direction) - static_cast<std::size_t>(Direction::x);
}

} // namespace

ciel::Vec3d slab_normal(scene::VolumeLayer::Direction direction, const annotations::ViewCamera& camera, bool moving) {
    using Direction = scene::VolumeLayer::Direction;
    ciel::Vec3d view{};
    for (std::size_t axis = 0; axis < 3; ++axis) view[axis] = camera.target[axis] - camera.position[axis];
    // While the camera moves, slices perpendicular to the view would have to be cut again for each picture.
    if (direction == Direction::screen && !moving) return unit_vector(view);
    std::size_t axis = 0;
    for (std::size_t other = 1; other < 3; ++other)
        if (std::abs(view[other]) > std::abs(view[axis])) axis = other;
    if (const auto asked = axis_of(direction); asked && !sees_along_slabs(view, *asked, camera)) axis = *asked;
    if (!moving && sees_along_slabs(view, axis, camera)) return unit_vector(view);
    ciel::Vec3d normal{};
    normal[axis] = 1;
    return normal;
}

} // namespace server::geometry
