// Layers that show the whole mesh, or only the cells that a threshold keeps: boundary, edges, points, outline.
#include "geometry/layer_update.hpp"

#include "geometry/mesh_side.hpp"

#include <algorithm>

namespace server::geometry {
namespace {

std::shared_ptr<const Shape> cap_shape(const std::shared_ptr<const Shape>& cut,
                                       const std::vector<std::uint8_t>& cells) {
    if (cells.empty()) return cut;
    return triangles_shape(ciel::polygons_of_cells(cut->surface, cells));
}

// Arrays on patches have values only on the boundary, so a cap gets the color of the inner array of the same name.
scene::Coloring inner_color(const store::Dataset& dataset, scene::Coloring color) {
    constexpr std::string_view patch = "patch:";
    if (color.array.empty()) return color;
    const store::ScalarName name = store::parse_scalar(dataset, color.array);
    if (dataset.find(name.array)->association != store::Association::boundary_face) return color;
    const bool has_inside = name.array.starts_with(patch) && dataset.find(name.array.substr(patch.size())) != nullptr;
    color.array = has_inside ? color.array.substr(patch.size()) : std::string();
    return color;
}

} // namespace

Boundary& LayerUpdate::boundary(const scene::Layer& layer, const std::string& key, std::size_t index) {
    Boundary& kept = boundaries[{layer.id, index}];
    const std::size_t before = kept.memory_bytes();
    if (kept.key != key) {
        kept.shape = kept.of = nullptr;
        kept.cells.clear();
    }
    count(before, kept.memory_bytes());
    kept.key = key;
    return kept;
}

std::vector<std::uint8_t> LayerUpdate::cells_of(const scene::Threshold& threshold) const {
    const std::string array = store::parse_scalar(*dataset, threshold.array).array;
    if (dataset->find(array)->association == store::Association::cell) {
        std::vector<std::uint8_t> in_range;
        const auto values = loaded->stored_scalar(threshold.array, out.step, store::Association::cell);
        in_range.reserve(values->size());
        values->for_pieces([&](ciel::ValuesView piece) {
            const auto of_piece = ciel::cells_in_range(piece, threshold.range);
            in_range.insert(in_range.end(), of_piece.begin(), of_piece.end());
        });
        return in_range;
    }
    auto kept =
        ciel::cells_in_range(*loaded->scalar(threshold.array, out.step).field, threshold.range,
                             threshold.keep == scene::Threshold::Keep::any ? ciel::InRange::any : ciel::InRange::all);
    if (const auto sound = loaded->sound_cells(threshold.array, out.step))
        for (std::size_t cell = 0; cell < kept.size(); ++cell) kept[cell] = kept[cell] & sound->kept[cell];
    return kept;
}

Boundary* LayerUpdate::solid(const scene::Layer& layer, const std::vector<std::string>& groups,
                             const std::optional<scene::Threshold>& threshold, std::string key) {
    key += ' ' + std::to_string(step().mesh) + ' ' + std::to_string(step().coordinates);
    for (const auto& group : groups) key += '\0' + group;
    if (!threshold) return &boundary(layer, key);
    tell_left_out(threshold->array, false);
    const auto [low, high] = threshold->range;
    key += '\0' + std::to_string(out.step) + (threshold->keep == scene::Threshold::Keep::any ? " any " : " all ") +
           bits_of(low) + bits_of(high) + threshold->array;
    Boundary& kept = boundary(layer, key);
    if (kept.shape) return &kept;
    const std::size_t before = kept.memory_bytes();
    try {
        kept.cells = cells_of(*threshold);
        count(before, kept.memory_bytes());
    } catch (const store::NotWritten& missing) {
        leave_out(layer, missing);
        return nullptr;
    }
    return &kept;
}

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::SurfaceLayer& surface) {
    Boundary* kept = solid(layer, surface.groups, surface.threshold, "surface");
    if (kept == nullptr) return true;
    const std::size_t before = kept->memory_bytes();
    if (!kept->shape)
        kept->shape = triangles_shape(boundary_surface(*loaded, out.step, out.origin, surface.groups, kept->cells));
    add(kept->painted, kept->shape, surface.color, layer, true);
    add_edges(kept->outlined, kept->painted.sound, surface.edges, layer);
    count(before, kept->memory_bytes());
    return !surface.groups.empty() || add_caps(layer, surface, *kept); // patches enclose no solid, so they get no caps
}

// A plane that lies in a side of the mesh gets no cap, because the boundary faces of this side are already drawn.
bool LayerUpdate::add_caps(const scene::Layer& layer, const scene::SurfaceLayer& surface, const Boundary& solid) {
    for (std::size_t i = 0; i < caps.size(); ++i) {
        Cut& cut = cuts[{layer.id, i}];
        const std::size_t before = cut.memory_bytes();
        const double nu = use_plane(cut, plane_of(*caps[i]));
        const bool opens = !side_at(nu, cut.field);
        if (opens && !cut.extract(nu, false, stop)) return false;
        count(before, cut.memory_bytes());
        if (!opens) continue;
        Boundary& cap = boundary(layer, solid.key, i + 1);
        const std::size_t of_cap = cap.memory_bytes();
        if (!cap.shape || cap.of != cut.shape) cap.shape = cap_shape(cut.shape, solid.cells);
        cap.of = cut.shape;
        add(cap.painted, cap.shape, caps[i]->color.value_or(inner_color(*dataset, surface.color)), layer, true);
        add_edges(cap.outlined, cap.painted.sound, surface.edges, layer);
        count(of_cap, cap.memory_bytes());
    }
    return true;
}

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::EdgesLayer& edges) {
    const std::string what = "edges " + (edges.angle ? bits_of(*edges.angle) : std::string("all"));
    Boundary* kept = solid(layer, edges.groups, edges.threshold, what);
    if (kept == nullptr) return true;
    const std::size_t before = kept->memory_bytes();
    if (!kept->shape)
        kept->shape =
            edges_shape(boundary_surface(*loaded, out.step, out.origin, edges.groups, kept->cells), edges.angle);
    add(kept->painted, kept->shape, edges.color, layer, false);
    out.drawables.back().line_width = edges.width;
    count(before, kept->memory_bytes());
    return true;
}

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::PointsLayer& points) {
    const bool all = points.of == scene::PointsLayer::Of::all;
    const std::string what = (all ? "points of all " : "points ") + std::to_string(points.most);
    Boundary* kept = solid(layer, points.groups, points.threshold, what);
    if (kept == nullptr) return true;
    const std::size_t before = kept->memory_bytes();
    if (!kept->shape) {
        const ciel::Surface vertices =
            all ? loaded->vertices_of_cells(out.step, kept->cells, out.origin)
                : boundary_surface(*loaded, out.step, out.origin, points.groups, kept->cells);
        kept->points = vertices.positions.size();
        kept->thinned = std::max<std::size_t>(1, (kept->points + points.most - 1) / points.most);
        kept->shape = points_shape(vertices, kept->thinned);
    }
    if (kept->thinned > 1)
        out.remarks.push_back("layer " + layer.id + " shows one in " + std::to_string(kept->thinned) + " of its " +
                              std::to_string(kept->points) + " points; raise \"most\" to see more");
    add(kept->painted, kept->shape, points.color, layer, true);
    out.drawables.back().line_width = points.size;
    count(before, kept->memory_bytes());
    return true;
}

bool LayerUpdate::operator()(const scene::Layer& layer, const scene::OutlineLayer& outline) {
    Boundary& kept = boundary(layer, "outline " + std::to_string(step().mesh));
    if (!kept.shape) kept.shape = outline_shape(out.bounds_min, out.bounds_max, out.origin);
    scene::Coloring solid = outline.color;
    solid.array.clear(); // a box has no values
    if (!outline.color.array.empty())
        out.remarks.push_back("layer " + layer.id + " has no colors of " + outline.color.array +
                              ": an outline is a box without values; leave color.array out of the layer, or color "
                              "another layer by the array");
    add(kept.painted, kept.shape, solid, layer, false);
    return true;
}

} // namespace server::geometry
