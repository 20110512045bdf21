#include "geometry/layer_update.hpp"

#include "geometry/color_scale_of.hpp"
#include "geometry/sound_shape.hpp"
#include "limits/errors.hpp"
#include "store/cell_extremes.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace server::geometry {
std::array<double, 2> range_of(const store::Dataset& dataset, const std::string& scalar, std::size_t step) {
    const store::ScalarName name = store::parse_scalar(dataset, scalar);
    const auto& arrays = dataset.steps()[step].arrays;
    const bool doubles = dataset.find(name.array)->doubles;
    const auto found = arrays.find(name.array);
    if (found == arrays.end()) return {0, 1};
    const auto& info = found->second;
    const auto& range =
        name.component ? info.component_ranges.at(static_cast<std::size_t>(*name.component)) : info.range;
    if (doubles) return range;
    // The range is rounded to floats, because the ends of a magnitude's range may be doubles that no float is equal to.
    return {static_cast<float>(range[0]), static_cast<float>(range[1])};
}

std::string full_name(const store::Dataset& dataset, const std::string& scalar) {
    const store::ScalarName name = store::parse_scalar(dataset, scalar);
    return name.magnitude ? name.array + ":magnitude" : scalar;
}

namespace {

// Returns the number with at most 4 significant digits, so that a line of a legend fits narrow pictures.
std::string short_number(double value) {
    std::ostringstream text;
    text << std::setprecision(4) << value;
    return text.str();
}

std::array<float, 4> with_opacity(const scene::Color& color, float opacity) {
    const std::array<float, 3> channels = color::floats_of(color);
    return {channels[0], channels[1], channels[2], opacity};
}

} // namespace

std::string bits_of(double number) { return {reinterpret_cast<const char*>(&number), sizeof number}; }

std::string plane_name(const std::array<double, 3>& normal, const store::Step& step) {
    std::string name = "plane " + std::to_string(step.mesh) + " " + std::to_string(step.coordinates);
    for (const double component : normal) {
        name.push_back(' ');
        name += bits_of(component);
    }
    return name;
}

store::ScalarField LayerUpdate::drawn(store::ScalarField field) const {
    field.set_surface_origin(out.origin);
    return field;
}

void LayerUpdate::count(std::size_t before, std::size_t after) {
    bytes = bytes - before + after;
    if (bytes > most_bytes)
        throw limits::LimitReached("the surfaces of this scene need more than the " + std::to_string(most_bytes >> 20) +
                                   " MB that a scene may have; show fewer values or layers");
}

void LayerUpdate::lack(const scene::Layer& layer, const char* what, const store::NotWritten& missing) const {
    out.lacking.push_back("layer " + layer.id + " " + what + ": " + missing.what());
    if (const auto* late = dynamic_cast<const store::NotYetRead*>(&missing); late != nullptr && !late->has_failed)
        out.awaited = late->what();
}

void LayerUpdate::leave_out(const scene::Layer& layer, const store::NotWritten& missing) const {
    lack(layer, "is not shown", missing);
    out.empty.push_back({layer.id, EmptyLayer::Why::missing, missing.what()});
}

void LayerUpdate::add(Painted& painted, const std::shared_ptr<const Shape>& shape, const scene::Coloring& coloring,
                      const scene::Layer& layer, bool lit, const OfArray& of) {
    scene::Coloring shown = coloring;
    try {
        painted.paint(shape, shown.array, out.step, *loaded, of);
    } catch (const store::NotWritten& missing) {
        lack(layer, "has no colors", missing);
        shown.array.clear();
        painted.paint(shape, shown.array, out.step, *loaded, {of.array, {}});
    }
    if (!shape->lines && !shape->points) {
        tell_left_out(of.array, true);
        tell_left_out(shown.array, false);
    }
    Drawable drawable;
    drawable.layer = layer.id;
    drawable.shape = painted.shown();
    drawable.scalars = painted.scalars;
    drawable.scalar_origin = painted.scalar_origin;
    drawable.missing = painted.missing;
    drawable.all_left_out = painted.sound->indices.empty() && !shape->indices.empty();
    drawable.lit = lit;
    drawable.identity = painted.identity;
    drawable.revision = painted.revision;
    color(drawable, shown, layer);
    if (drawable.polygons()) out.triangles += drawable.shape->indices.size() / 3;
    out.drawables.push_back(std::move(drawable));
}

std::vector<std::string> LayerUpdate::legend_lines(const std::string& scalar) const {
    std::vector<std::string> lines;
    const bool is_of_points =
        dataset->find(store::parse_scalar(*dataset, scalar).array)->association == store::Association::point;
    if (const auto found = store::cell_extremes(*dataset, scalar, out.step); found && is_of_points)
        lines.push_back("cells: " + short_number(found->lowest.value) + " to " + short_number(found->highest.value));
    if (const auto sound = loaded->sound_cells(scalar, out.step))
        lines.push_back(std::to_string(sound->left_out) + (sound->left_out == 1 ? " cell" : " cells") + " left out");
    return lines;
}

void LayerUpdate::tell_left_out(const std::string& scalar, bool is_cut) const {
    if (scalar.empty()) return;
    std::string text = left_out_text(scalar, is_cut, out.step, *loaded);
    if (!text.empty() && std::ranges::find(out.remarks, text) == out.remarks.end())
        out.remarks.push_back(std::move(text));
}

void LayerUpdate::color(Drawable& drawable, const scene::Coloring& coloring, const scene::Layer& layer) const {
    drawable.color = with_opacity(coloring.solid, layer.opacity);
    if (coloring.array.empty()) return;
    drawable.array = full_name(*dataset, coloring.array);
    const std::array<double, 2> range = range_of(*dataset, coloring.array, out.step);
    drawable.units = dataset->find(store::parse_scalar(*dataset, coloring.array).array)->units;
    drawable.legend_lines = legend_lines(coloring.array);
    drawable.scale = color_scale_of(coloring, range);
    if (!is_shown_by(coloring, range))
        out.lacking.push_back("layer " + layer.id + " has no colors: " + coloring.array +
                              " has no value above zero at this time; choose a linear scale");
}

void LayerUpdate::add_edges(Outlined& outlined, const std::shared_ptr<const Shape>& shape,
                            const std::optional<scene::Edges>& edges, const scene::Layer& layer) {
    if (!edges) return outlined.forget();
    outlined.follow(shape);
    add_lines(shape, edges->color, edges->width, layer, outlined.identity, outlined.revision).edges = outlined.edges;
}

Drawable& LayerUpdate::add_lines(const std::shared_ptr<const Shape>& shape, const scene::Color& color, float width,
                                 const scene::Layer& layer, std::uint64_t identity, std::uint64_t revision) {
    Drawable drawable;
    drawable.layer = layer.id;
    drawable.shape = shape;
    drawable.line_width = width;
    drawable.color = with_opacity(color, layer.opacity);
    drawable.lit = false;
    drawable.identity = identity;
    drawable.revision = revision;
    out.drawables.push_back(std::move(drawable));
    return out.drawables.back();
}

} // namespace server::geometry
