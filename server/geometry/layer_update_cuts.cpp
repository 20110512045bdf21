// Layers that cut the mesh: iso-surfaces and slices.
#include "geometry/layer_update.hpp"

#include "annotations/ticks.hpp"
#include "ciel/vector_operators.hpp"
#include "geometry/mesh_side.hpp"

#include <algorithm>
#include <cmath>

namespace server::geometry {
namespace {

// `largest`: upper bound of the mesh's coordinates; rounding errors are proportional to it.
bool coincide(const scene::Plane& slice, const scene::Plane& clip, double largest) {
    double cosine = 0, apart = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        cosine += slice.normal[axis] * clip.normal[axis];
        apart += clip.normal[axis] * (slice.origin[axis] - clip.origin[axis]);
    }
    return std::abs(cosine) >= 1 - 1e-13 && std::abs(apart) <= 1e-12 * largest;
}

std::vector<double> contour_values(const scene::Contours& contours, const scene::Range& own) {
    if (contours.values) return *contours.values;
    const auto [low, high] = contours.range.value_or(own);
    const std::size_t count = contours.count.value(); // scene/rules.cpp sets it in the absence of values
    std::vector<double> values;
    for (std::size_t i = 1; i <= count; ++i)
        values.push_back(low + (high - low) * static_cast<double>(i) / static_cast<double>(count + 1));
    return values;
}

} // namespace

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::IsoLayer& iso) {
    for (std::size_t i = 0; i < iso.values.size(); ++i) {
        Cut& cut = cuts[{layer.id, i}];
        const std::size_t before = cut.memory_bytes();
        const std::string name = "field " + std::to_string(out.step) + " " + iso.array;
        try {
            if (cut.field_name != name) cut.use_field(name, drawn(loaded->scalar(iso.array, out.step)), extraction);
        } catch (const store::NotWritten& missing) {
            leave_out(layer, missing);
            return true;
        }
        if (!cut.extract(iso.values[i], iso.smooth, stop)) return false;
        const bool by_itself =
            !iso.color.array.empty() && full_name(*dataset, iso.color.array) == full_name(*dataset, iso.array);
        add(cut.painted, cut.shape, iso.color, layer, true,
            {iso.array, by_itself ? std::optional(iso.values[i]) : std::nullopt});
        add_edges(cut.outlined, cut.painted.sound, iso.edges, layer);
        count(before, cut.memory_bytes());
    }
    return true;
}

double LayerUpdate::use_plane(Cut& cut, const scene::Plane& plane) {
    const std::string name = plane_name(plane.normal, step());
    if (cut.field_name != name)
        cut.use_field(name, drawn(loaded->plane(out.step, out.origin, plane.normal)), extraction);
    double nu = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) nu += plane.normal[axis] * (plane.origin[axis] - out.origin[axis]);
    return nu;
}

const scene::ClipLayer* LayerUpdate::cap_at(const scene::SliceLayer& slice) const {
    const scene::Plane plane = plane_of(slice);
    const auto found = std::ranges::find_if(caps, [&](const scene::ClipLayer* clip) {
        return coincide(plane, plane_of(*clip), diagonal() + ciel::length(out.origin));
    });
    return found == caps.end() ? nullptr : *found;
}

bool LayerUpdate::cut_along(Cut& cut, double nu) const {
    const auto side = side_at(nu, cut.field);
    if (!side) return cut.extract(nu, false, stop);
    if (cut.shape && cut.nu == *side && !cut.normals) return true;
    ciel::Surface faces = side_surface(cut.field, *side);
    if (faces.polygon_cell.empty()) return cut.extract(*side, false, stop);
    cut.show(triangles_shape(std::move(faces)), *side);
    return true;
}

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::SliceLayer& slice) {
    Cut& cut = cuts[{layer.id, 0}];
    const std::size_t before = cut.memory_bytes();
    const scene::ClipLayer* cap = cap_at(slice);
    const double nu = use_plane(cut, cap != nullptr ? plane_of(*cap) : plane_of(slice));
    if (!cut_along(cut, nu)) return false;
    add(cut.painted, cut.shape, slice.color, layer, false);
    add_edges(cut.outlined, cut.painted.sound, slice.edges, layer);
    add_contours(cut.contoured, cut.painted.sound, slice.contours, layer);
    count(before, cut.memory_bytes());
    return true;
}

void LayerUpdate::add_contours(Contoured& contoured, const std::shared_ptr<const Shape>& shape,
                               const std::optional<scene::Contours>& contours, const scene::Layer& layer) {
    if (!contours) return contoured.forget();
    const auto own = range_of(*dataset, contours->array, out.step);
    const std::vector<double> values = contour_values(*contours, {own[0], own[1]});
    try {
        contoured.follow(shape, contours->array, out.step, values, contours->coloring.has_value(), *loaded);
    } catch (const store::NotWritten& missing) {
        return lack(layer, "has no contour lines", missing);
    }
    const int digits = annotations::digits_of_range(own[0], own[1]);
    if (contoured.lines->indices.empty() && !shape->indices.empty())
        out.remarks.push_back("layer " + layer.id + " has no contour lines: " + contours->array +
                              " takes none of the values of the lines on the layer; the data goes from " +
                              annotations::number_label(own[0], digits) + " to " +
                              annotations::number_label(own[1], digits) + " at this time");
    tell_left_out(contours->array, true);
    Drawable& lines =
        add_lines(contoured.lines, contours->color, contours->width, layer, contoured.identity, contoured.revision);
    lines.contours = true;
    if (!contours->coloring) return;
    lines.scalars = contoured.scalars;
    lines.scalar_origin = contoured.scalar_origin;
    color(lines, *contours->coloring, layer);
}

} // namespace server::geometry
