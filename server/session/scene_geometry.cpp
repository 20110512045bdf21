#include "session/scene_geometry.hpp"

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
    drawable.map = coloring.map;
    if (coloring.array.empty()) return;
    drawable.range = range_of(dataset, coloring.array, step);
    if (coloring.range)
        drawable.range = {static_cast<float>((*coloring.range)[0]), static_cast<float>((*coloring.range)[1])};
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

std::string plane_name(const scene::SliceLayer& slice, const store::Step& step) {
    std::string name = "plane " + std::to_string(step.mesh) + " " + std::to_string(step.coordinates);
    for (const double component : slice.normal) {
        name.push_back(' ');
        name.append(reinterpret_cast<const char*>(&component), sizeof component); // all its bits: a key, not a text
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
    std::size_t bytes; // of all that is kept

    [[nodiscard]] const store::Step& step() const { return dataset->steps()[out.step]; }

    // Looked at after each surface, so that a scene which is too large is never made.
    void count(std::size_t before, std::size_t after) {
        bytes = bytes - before + after;
        if (bytes > most_bytes)
            throw LimitReached("the surfaces of this scene need more than the " + std::to_string(most_bytes >> 20) +
                               " MB that a scene may have; show fewer values or layers");
    }

    void add(Painted& painted, const std::shared_ptr<const Shape>& shape, const scene::Coloring& coloring,
             const scene::Layer& layer, bool lit) {
        scene::Coloring shown = coloring;
        try {
            painted.paint(shape, shown.array, out.step, *loaded);
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
        if (!shape->lines) out.triangles += shape->indices.size() / 3;
        out.drawables.push_back(std::move(drawable));
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
            add(cut.painted, cut.shape, iso.color, layer, true);
            count(before, cut.memory_bytes());
        }
        return true;
    }

    // The field is measured from the mesh's origin, whatever the slice's, so that a slice that moves along its normal
    // is only another nu of the same field.
    bool operator()(const scene::Layer& layer, const scene::SliceLayer& slice) {
        Cut& cut = cuts[{layer.id, 0}];
        const std::size_t before = cut.memory_bytes();
        const std::string name = plane_name(slice, step());
        if (cut.field_name != name) cut.use_field(name, loaded->plane(out.step, out.origin, slice.normal), extraction);
        double nu = 0;
        for (std::size_t axis = 0; axis < 3; ++axis) nu += slice.normal[axis] * (slice.origin[axis] - out.origin[axis]);
        if (!cut.extract(on_the_side(nu, cut.field.field->range()), false, stop)) return false;
        add(cut.painted, cut.shape, slice.color, layer, false);
        count(before, cut.memory_bytes());
        return true;
    }

    bool operator()(const scene::Layer& layer, const scene::SurfaceLayer& surface) {
        std::string key = "surface " + std::to_string(step().mesh) + " " + std::to_string(step().coordinates);
        for (const auto& group : surface.groups) key += '\0' + group;
        Boundary& kept = boundary(layer, key);
        const std::size_t before = kept.memory_bytes();
        if (!kept.shape) kept.shape = boundary_shape(*dataset, step(), surface.groups);
        add(kept.painted, kept.shape, surface.color, layer, true);
        count(before, kept.memory_bytes());
        return true;
    }

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
        const std::string place = plane_name({{}, normal, {}}, step());
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
        drawable.map = volume.color.map;
        drawable.range = range_of(*dataset, volume.array, out.step);
        if (volume.color.range)
            drawable.range = {static_cast<float>((*volume.color.range)[0]),
                              static_cast<float>((*volume.color.range)[1])};
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

    Boundary& boundary(const scene::Layer& layer, const std::string& key) {
        Boundary& kept = boundaries[{layer.id, 0}];
        const std::size_t before = kept.memory_bytes();
        if (kept.key != key) kept.shape = nullptr;
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
    geometry->origin = dataset->mesh(step.mesh, step.coordinates).origin;
    geometry->bounds_min = low(dataset->info().meshes[step.mesh]);
    geometry->bounds_max = high(dataset->info().meshes[step.mesh]);

    forget_all_but(scene); // first, for what comes needs the room
    // Any aspect: the default camera looks the same way.
    Update run{extraction_, loaded,     dataset,
               stop,        *geometry,  cuts_,
               boundaries_, volumes_,   camera_of(*geometry, scene, 1),
               moving,      most_bytes, memory_bytes()};
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
    for (const scene::Layer& layer : scene.layers) {
        const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind);
        if (layer.visible) shown.insert(layer.id);
        if (!layer.visible)
            cuts_of[layer.id] = SIZE_MAX; // showing it again costs nothing
        else
            cuts_of[layer.id] = iso != nullptr ? iso->values.size() : 1;
    }
    std::erase_if(cuts_, [&](const auto& entry) {
        const auto kept = cuts_of.find(entry.first.first);
        return kept == cuts_of.end() || entry.first.second >= kept->second;
    });
    std::erase_if(boundaries_, [&](const auto& entry) { return !shown.contains(entry.first.first); });
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
