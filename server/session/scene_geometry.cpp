#include "session/scene_geometry.hpp"

#include "ciel/threshold_surface.hpp"
#include "session/clip.hpp"
#include "session/color_scale_of.hpp"
#include "session/cut.hpp"
#include "session/errors.hpp"
#include "session/volume_cut.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace ciel::session {
namespace {

Vec3d low(const store::MeshInfo& mesh) { return {mesh.bounds[0], mesh.bounds[2], mesh.bounds[4]}; }
Vec3d high(const store::MeshInfo& mesh) { return {mesh.bounds[1], mesh.bounds[3], mesh.bounds[5]}; }

std::array<float, 2> range_of(const store::Dataset& dataset, const std::string& scalar, std::size_t step) {
    const store::ScalarName name = store::parse_scalar(dataset, scalar);
    const auto& arrays = dataset.steps()[step].arrays;
    const auto found = arrays.find(name.array);
    if (found == arrays.end()) return {0, 1};
    const auto& info = found->second;
    const auto& range =
        name.component ? info.component_ranges.at(static_cast<std::size_t>(*name.component)) : info.range;
    return {static_cast<float>(range[0]), static_cast<float>(range[1])};
}

void colour(Drawable& drawable, const scene::Coloring& coloring, const scene::Layer& layer,
            const store::Dataset& dataset, std::size_t step) {
    drawable.color = {coloring.solid[0], coloring.solid[1], coloring.solid[2], layer.opacity};
    drawable.array = coloring.array;
    if (coloring.array.empty()) return;
    drawable.units = dataset.find(store::parse_scalar(dataset, coloring.array).array)->units;
    drawable.scale = color_scale_of(coloring, range_of(dataset, coloring.array, step));
}

// High means value >= nu, so a plane on the low side of the domain would cut nothing. One that is off a side by no more
// than rounding means the side.
double on_the_side(double nu, std::array<float, 2> range) {
    const auto [low, high] = range;
    const double rounding = 1e-6 * (static_cast<double>(high) - static_cast<double>(low));
    if (nu <= low && nu >= low - rounding) return std::nextafter(low, high);
    if (nu > high && nu <= high + rounding) return high;
    return nu;
}

std::string bits_of(double number) { // all its bits: a key, not a text
    return {reinterpret_cast<const char*>(&number), sizeof number};
}

// Of a cut through the whole mesh what belongs to the cells that are shown.
std::shared_ptr<const Shape> cap_shape(const std::shared_ptr<const Shape>& cut,
                                       const std::vector<std::uint8_t>& cells) {
    if (cells.empty()) return cut;
    return triangles_shape(polygons_of_cells(cut->surface, cells));
}

std::string plane_name(const std::array<double, 3>& normal, const store::Step& step) {
    std::string name = "plane " + std::to_string(step.mesh) + " " + std::to_string(step.coordinates);
    for (const double component : normal) {
        name.push_back(' ');
        name += bits_of(component);
    }
    return name;
}

// One update: what each kind of layer does, and which kept state was still in use.
struct Update {
    Extraction extraction;
    const std::shared_ptr<store::LoadedDataset>& loaded;
    std::shared_ptr<store::Dataset> dataset;
    const std::stop_token& stop;
    Geometry& out;
    std::map<std::pair<std::string, std::size_t>, Cut>& cuts;
    std::map<std::pair<std::string, std::size_t>, Boundary>& boundaries;
    std::map<std::string, VolumeCut>& volumes;
    const render::Camera camera;
    const bool moving;
    const std::size_t most_bytes;
    std::size_t bytes;                           // of all that is kept
    std::vector<const scene::ClipLayer*> caps{}; // that surfaces get

    [[nodiscard]] const store::Step& step() const { return dataset->steps()[out.step]; }

    // Looked at after each surface, so that a scene which is too large is never made.
    void count(std::size_t before, std::size_t after) {
        bytes = bytes - before + after;
        if (bytes > most_bytes)
            throw LimitReached("the surfaces of this scene need more than the " + std::to_string(most_bytes >> 20) +
                               " MB that a scene may have; show fewer values or layers");
    }

    // `own`: the value that the shape has of the array that it is coloured by, where it has one.
    void add(Painted& painted, const std::shared_ptr<const Shape>& shape, const scene::Coloring& coloring,
             const scene::Layer& layer, bool lit, std::optional<double> own = {}) {
        scene::Coloring shown = coloring;
        try {
            painted.paint(shape, shown.array, out.step, *loaded, own);
        } catch (const store::NotWritten& missing) {
            lack(layer, "has no colours", missing);
            shown.array.clear();
            painted.paint(shape, shown.array, out.step, *loaded);
        }
        Drawable drawable;
        drawable.layer = layer.id;
        drawable.shape = shape;
        drawable.scalars = painted.scalars;
        drawable.lit = lit;
        drawable.identity = painted.identity;
        drawable.revision = painted.revision;
        colour(drawable, shown, layer, *dataset, out.step);
        if (!shown.array.empty() && !is_shown_by(shown, range_of(*dataset, shown.array, out.step)))
            out.lacking.push_back("layer " + layer.id + " has no colours: " + shown.array +
                                  " has no value above zero at this time, and only those have a place on a "
                                  "logarithmic scale; choose a linear one");
        if (drawable.polygons()) out.triangles += shape->indices.size() / 3;
        out.drawables.push_back(std::move(drawable));
    }

    void add_edges(Outlined& outlined, const std::shared_ptr<const Shape>& shape,
                   const std::optional<scene::LineStyle>& style, const scene::Layer& layer) {
        if (!style) return outlined.forget();
        outlined.follow(shape);
        add_lines(shape, *style, layer, outlined.identity, outlined.revision).edges = outlined.edges;
    }

    Drawable& add_lines(const std::shared_ptr<const Shape>& shape, const scene::LineStyle& style,
                        const scene::Layer& layer, std::uint64_t identity, std::uint64_t revision) {
        Drawable drawable;
        drawable.layer = layer.id;
        drawable.shape = shape;
        drawable.line_width = style.width;
        drawable.color = {style.color[0], style.color[1], style.color[2], layer.opacity};
        drawable.lit = false;
        drawable.identity = identity;
        drawable.revision = revision;
        out.drawables.push_back(std::move(drawable));
        return out.drawables.back();
    }

    void add_contours(Contoured& contoured, const std::shared_ptr<const Shape>& shape,
                      const std::optional<scene::Contours>& contours, const scene::Layer& layer) {
        if (!contours) return contoured.forget();
        std::vector<double> values = contours->values;
        const auto own = range_of(*dataset, contours->array, out.step);
        const auto [low, high] = contours->range.value_or(std::array<double, 2>{own[0], own[1]});
        for (int i = 1; i <= contours->count; ++i) values.push_back(low + (high - low) * i / (contours->count + 1));
        try {
            contoured.follow(shape, contours->array, out.step, values, *loaded);
        } catch (const store::NotWritten& missing) {
            return lack(layer, "has no contour lines", missing);
        }
        add_lines(contoured.lines, contours->line, layer, contoured.identity, contoured.revision);
    }

    void lack(const scene::Layer& layer, const char* what, const store::NotWritten& missing) const {
        out.lacking.push_back("layer " + layer.id + " " + what + ": " + missing.what());
    }

    bool operator()(const scene::Layer& layer, const scene::IsoLayer& iso) {
        for (std::size_t i = 0; i < iso.values.size(); ++i) {
            Cut& cut = cuts[{layer.id, i}];
            const std::size_t before = cut.memory_bytes();
            const std::string name = "field " + std::to_string(out.step) + " " + iso.array;
            try {
                if (cut.field_name != name) cut.use_field(name, loaded->scalar(iso.array, out.step), extraction);
            } catch (const store::NotWritten& missing) {
                lack(layer, "is not shown", missing);
                return true;
            }
            if (!cut.extract(iso.values[i], iso.smooth, stop)) return false;
            const bool by_itself = iso.color.array == iso.array;
            add(cut.painted, cut.shape, iso.color, layer, true,
                by_itself ? std::optional(iso.values[i]) : std::nullopt);
            add_edges(cut.outlined, cut.shape, iso.edges, layer);
            count(before, cut.memory_bytes());
        }
        return true;
    }

    // The field is measured from the mesh's origin, whatever the plane's, so that a plane that moves along its normal
    // is only another nu of the same field. Returns nu.
    double use_plane(Cut& cut, const std::array<double, 3>& origin, const std::array<double, 3>& normal) {
        const std::string name = plane_name(normal, step());
        if (cut.field_name != name) cut.use_field(name, loaded->plane(out.step, out.origin, normal), extraction);
        double nu = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) nu += normal[axis] * (origin[axis] - out.origin[axis]);
        return nu;
    }

    bool operator()(const scene::Layer& layer, const scene::SliceLayer& slice) {
        Cut& cut = cuts[{layer.id, 0}];
        const std::size_t before = cut.memory_bytes();
        const double nu = use_plane(cut, slice.origin, slice.normal);
        if (!cut.extract(on_the_side(nu, cut.field.field->range()), false, stop)) return false;
        add(cut.painted, cut.shape, slice.color, layer, false);
        add_edges(cut.outlined, cut.shape, slice.edges, layer);
        add_contours(cut.contoured, cut.shape, slice.contours, layer);
        count(before, cut.memory_bytes());
        return true;
    }

    bool operator()(const scene::Layer& layer, const scene::SurfaceLayer& surface) {
        Boundary* kept = solid(layer, surface.groups, surface.threshold, "surface");
        if (kept == nullptr) return true;
        const std::size_t before = kept->memory_bytes();
        if (!kept->shape)
            kept->shape = triangles_shape(boundary_surface(*dataset, step(), surface.groups, kept->cells));
        add(kept->painted, kept->shape, surface.color, layer, true);
        add_edges(kept->outlined, kept->shape, surface.edges, layer);
        count(before, kept->memory_bytes());
        return !surface.groups.empty() || add_caps(layer, surface, *kept); // patches are no solid
    }

    // Each is the whole slice of the mesh by its plane: the other planes cut it as they cut everything.
    bool add_caps(const scene::Layer& layer, const scene::SurfaceLayer& surface, const Boundary& solid) {
        for (std::size_t i = 0; i < caps.size(); ++i) {
            Cut& cut = cuts[{layer.id, i}];
            const std::size_t before = cut.memory_bytes();
            if (!cut.extract(use_plane(cut, caps[i]->origin, caps[i]->normal), false, stop)) return false;
            count(before, cut.memory_bytes());
            Boundary& cap = boundary(layer, solid.key, i + 1);
            const std::size_t of_cap = cap.memory_bytes();
            if (!cap.shape || cap.of != cut.shape) cap.shape = cap_shape(cut.shape, solid.cells);
            cap.of = cut.shape;
            add(cap.painted, cap.shape, surface.color, layer, true);
            add_edges(cap.outlined, cap.shape, surface.edges, layer);
            count(of_cap, cap.memory_bytes());
        }
        return true;
    }

    [[nodiscard]] std::vector<std::uint8_t> cells_of(const scene::Threshold& threshold) const {
        const std::string array = store::parse_scalar(*dataset, threshold.array).array;
        if (dataset->find(array)->association == store::Association::cell)
            return cells_in_range(*loaded->cell_values(threshold.array, out.step), threshold.range);
        return cells_in_range(dataset->mesh(step().mesh, step().coordinates),
                              *loaded->scalar_values(threshold.array, out.step), threshold.range,
                              threshold.any ? InRange::any : InRange::all);
    }

    // The state of what a layer shows of the mesh's cells; null where its threshold has no values.
    Boundary* solid(const scene::Layer& layer, const std::vector<std::string>& groups,
                    const std::optional<scene::Threshold>& threshold, std::string key) {
        key += ' ' + std::to_string(step().mesh) + ' ' + std::to_string(step().coordinates);
        for (const auto& group : groups) key += '\0' + group;
        if (!threshold) return &boundary(layer, key);
        const auto [low, high] = threshold->range;
        key += '\0' + std::to_string(out.step) + (threshold->any ? " any " : " all ") + bits_of(low) + bits_of(high) +
               threshold->array;
        Boundary& kept = boundary(layer, key);
        if (kept.shape) return &kept;
        const std::size_t before = kept.memory_bytes();
        try {
            kept.cells = cells_of(*threshold);
            count(before, kept.memory_bytes());
        } catch (const store::NotWritten& missing) {
            lack(layer, "is not shown", missing);
            return nullptr;
        }
        return &kept;
    }

    bool operator()(const scene::Layer& layer, const scene::EdgesLayer& edges) {
        const std::string what = "edges " + (edges.angle ? bits_of(*edges.angle) : std::string("all"));
        Boundary* kept = solid(layer, edges.groups, edges.threshold, what);
        if (kept == nullptr) return true;
        const std::size_t before = kept->memory_bytes();
        if (!kept->shape)
            kept->shape = edges_shape(boundary_surface(*dataset, step(), edges.groups, kept->cells), edges.angle);
        add(kept->painted, kept->shape, edges.color, layer, false);
        out.drawables.back().line_width = edges.width;
        count(before, kept->memory_bytes());
        return true;
    }

    bool operator()(const scene::Layer& layer, const scene::PointsLayer& points) {
        const std::string what = (points.all ? "points of all " : "points ") + std::to_string(points.most);
        Boundary* kept = solid(layer, points.groups, points.threshold, what);
        if (kept == nullptr) return true;
        const std::size_t before = kept->memory_bytes();
        if (!kept->shape) {
            const Surface vertices = points.all
                                         ? cell_vertices(dataset->mesh(step().mesh, step().coordinates), kept->cells)
                                         : boundary_surface(*dataset, step(), points.groups, kept->cells);
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

    bool operator()(const scene::Layer&, const scene::ClipLayer&) { return true; } // Geometry::clip and caps

    bool operator()(const scene::Layer& layer, const scene::OutlineLayer& outline) {
        Boundary& kept = boundary(layer, "outline " + std::to_string(step().mesh));
        if (!kept.shape) kept.shape = outline_shape(out.bounds_min, out.bounds_max, out.origin);
        scene::Coloring solid = outline.color;
        solid.array.clear(); // a box has no values
        add(kept.painted, kept.shape, solid, layer, false);
        return true;
    }

    bool operator()(const scene::Layer& layer, const scene::VolumeLayer& volume) {
        VolumeCut& kept = volumes[layer.id];
        const std::size_t before = kept.memory_bytes();
        try {
            kept.use_property(volume.array, out.step, *loaded);
        } catch (const store::NotWritten& missing) {
            lack(layer, "is not shown", missing);
            return true;
        }
        const Vec3d normal = slab_normal(volume, camera, moving);
        const store::ScalarField planes = loaded->plane(out.step, out.origin, normal);
        const std::string place = plane_name(normal, step());
        if (!kept.cut(place, planes, normal, volume.slices, moving, stop)) return false;
        out.volumes.push_back(drawable_of(layer, volume, kept));
        count(before, kept.memory_bytes());
        return true;
    }

    [[nodiscard]] VolumeDrawable drawable_of(const scene::Layer& layer, const scene::VolumeLayer& volume,
                                             const VolumeCut& kept) const {
        VolumeDrawable drawable;
        drawable.layer = layer.id;
        drawable.slabs = kept.slabs;
        drawable.stride = moving ? moving_stride(volume.slices) : 1;
        drawable.array = volume.array;
        drawable.units = dataset->find(store::parse_scalar(*dataset, volume.array).array)->units;
        drawable.scale = color_scale_of(volume.color, range_of(*dataset, volume.array, out.step));
        drawable.opacity_points = volume.opacity_points;
        drawable.unit_length = volume.unit_length.value_or(0.1 * diagonal());
        drawable.shaded = volume.shaded;
        drawable.opacity = layer.opacity;
        drawable.identity = kept.identity;
        drawable.revision = kept.revision;
        return drawable;
    }

    [[nodiscard]] double diagonal() const {
        return std::hypot(out.bounds_max[0] - out.bounds_min[0], out.bounds_max[1] - out.bounds_min[1],
                          out.bounds_max[2] - out.bounds_min[2]);
    }

    Boundary& boundary(const scene::Layer& layer, const std::string& key, std::size_t index = 0) {
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
};

} // namespace

void require_complete(const Geometry& geometry) {
    if (!geometry.lacking.empty()) throw store::NotWritten(geometry.lacking.front());
}

SceneGeometry::SceneGeometry(Extraction extraction) : extraction_(extraction) {}
SceneGeometry::~SceneGeometry() = default;
SceneGeometry::SceneGeometry(SceneGeometry&&) noexcept = default;
SceneGeometry& SceneGeometry::operator=(SceneGeometry&&) noexcept = default;

std::shared_ptr<const Geometry> SceneGeometry::update(const scene::Scene& scene,
                                                      const std::shared_ptr<store::LoadedDataset>& loaded,
                                                      const std::stop_token& stop, std::size_t most_bytes,
                                                      bool moving) {
    if (loaded != loaded_) {
        cuts_.clear();
        boundaries_.clear();
        volumes_.clear();
        loaded_ = loaded;
    }
    const auto dataset = loaded->dataset();
    if (dataset->steps().empty()) throw Error(dataset->info().name + " has no time step yet; append one to see it");
    check_names(scene, *dataset);

    auto geometry = std::make_shared<Geometry>();
    geometry->step = dataset->step_at(scene.time);
    const store::Step& step = dataset->steps()[geometry->step];
    geometry->time = step.time;
    geometry->length_units = dataset->info().length_units;
    geometry->origin = dataset->mesh(step.mesh, step.coordinates).origin;
    geometry->bounds_min = low(dataset->info().meshes[step.mesh]);
    geometry->bounds_max = high(dataset->info().meshes[step.mesh]);

    geometry->clip = clip_planes(scene, geometry->origin);
    forget_all_but(scene); // first, for what comes needs the room
    // Any aspect: the default camera looks the same way.
    Update run{extraction_,   loaded,     dataset,
               stop,          *geometry,  cuts_,
               boundaries_,   volumes_,   camera_of(*geometry, scene, 1),
               moving,        most_bytes, memory_bytes(),
               capping(scene)};
    for (const scene::Layer& layer : scene.layers) {
        if (!layer.visible) continue;
        const auto make = [&](const auto& kind) { return run(layer, kind); };
        if (!std::visit(make, layer.kind)) return nullptr;
    }
    dataset->check_intact();
    geometry->bytes = memory_bytes();
    return geometry;
}

void SceneGeometry::forget_all_but(const scene::Scene& scene) {
    std::map<std::string, std::size_t> cuts_of; // how many stay
    std::set<std::string> shown;
    const std::size_t caps = capping(scene).size();
    for (const scene::Layer& layer : scene.layers) {
        const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind);
        const auto* surface = std::get_if<scene::SurfaceLayer>(&layer.kind);
        if (layer.visible) shown.insert(layer.id);
        if (!layer.visible)
            cuts_of[layer.id] = SIZE_MAX; // showing it again costs nothing
        else if (surface != nullptr)
            cuts_of[layer.id] = surface->groups.empty() ? caps : 0;
        else
            cuts_of[layer.id] = iso != nullptr ? iso->values.size() : 1;
    }
    std::erase_if(cuts_, [&](const auto& entry) {
        const auto kept = cuts_of.find(entry.first.first);
        return kept == cuts_of.end() || entry.first.second >= kept->second;
    });
    std::erase_if(boundaries_, [&](const auto& entry) {
        return !shown.contains(entry.first.first) || entry.first.second > cuts_of[entry.first.first];
    });
    std::erase_if(volumes_, [&](const auto& entry) { return !shown.contains(entry.first); });
}

std::size_t SceneGeometry::memory_bytes() const {
    std::size_t bytes = 0;
    for (const auto& [key, cut] : cuts_) bytes += cut.memory_bytes();
    for (const auto& [key, boundary] : boundaries_) bytes += boundary.memory_bytes();
    for (const auto& [layer, volume] : volumes_) bytes += volume.memory_bytes();
    return bytes;
}

} // namespace ciel::session
