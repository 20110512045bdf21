#include "geometry/scene_geometry.hpp"

#include "annotations/ticks.hpp"
#include "ciel/printable.hpp"
#include "geometry/clip.hpp"
#include "geometry/drawing_origin.hpp"
#include "geometry/empty_layers.hpp"
#include "geometry/layer_update.hpp"
#include "geometry/viewpoint.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace server::geometry {
namespace {

ciel::Vec3d low(const store::MeshInfo& mesh) { return {mesh.bounds[0], mesh.bounds[2], mesh.bounds[4]}; }
ciel::Vec3d high(const store::MeshInfo& mesh) { return {mesh.bounds[1], mesh.bounds[3], mesh.bounds[5]}; }

// A scene without a time has the time 0 and gets no remark.
void remark_on_time(double wanted, Geometry& geometry) {
    const double off = std::abs(geometry.time - wanted);
    if (wanted == 0 || off <= 1e-6 * std::max(std::abs(geometry.time), std::abs(wanted))) return;
    geometry.remarks.push_back("there is no step at time " + annotations::number_label(wanted) + "; the nearest, " +
                               annotations::number_label(geometry.time) + ", is shown");
}

} // namespace

void require_read(const Geometry& geometry) {
    if (!geometry.awaited.empty()) throw store::NotYetRead(geometry.awaited, false);
}

void require_complete(const Geometry& geometry) {
    require_read(geometry);
    if (!geometry.lacking.empty()) throw store::NotWritten(ciel::printable(geometry.lacking.front()));
}

SceneGeometry::SceneGeometry(ciel::Extraction extraction) : extraction_(extraction) {}
SceneGeometry::~SceneGeometry() = default;
SceneGeometry::SceneGeometry(SceneGeometry&&) noexcept = default;
SceneGeometry& SceneGeometry::operator=(SceneGeometry&&) noexcept = default;

std::shared_ptr<const Geometry> SceneGeometry::update(const scene::CheckedScene& checked, const std::stop_token& stop,
                                                      std::size_t most_bytes, bool moving,
                                                      const LayersMade& layers_made) {
    const scene::Scene& scene = checked.scene();
    const auto& loaded = checked.loaded();
    if (loaded != loaded_) {
        forget_all();
        loaded_ = loaded;
    }
    const auto& dataset = checked.dataset();
    if (dataset->steps().empty()) throw ciel::Error(dataset->info().name + " has no time step yet; append a step");

    auto geometry = std::make_shared<Geometry>();
    geometry->step = dataset->step_at(scene.time);
    const store::Step& step = dataset->steps()[geometry->step];
    geometry->time = step.time;
    remark_on_time(scene.time, *geometry);
    geometry->length_units = dataset->info().length_units;
    geometry->first_mesh_bounds = dataset->info().meshes.at(0).bounds;
    geometry->bounds_min = low(dataset->info().meshes[step.mesh]);
    geometry->bounds_max = high(dataset->info().meshes[step.mesh]);
    geometry->double_positions = dataset->info().meshes[step.mesh].double_positions;
    // The aspect 1 is arbitrary, because the aspect does not affect the direction of the default camera.
    const annotations::ViewCamera camera = camera_of(*geometry, scene.camera, 1);
    geometry->origin = drawing_origin(store::middle_of(dataset->info().meshes[step.mesh]), origin_, camera);
    if (geometry->origin != origin_) {
        forget_all();
        origin_ = geometry->origin;
    }

    geometry->clip = clip_planes(checked, *geometry);
    forget_all_but(checked); // first, to free memory for new state
    const auto direction = slab_direction(checked);
    LayerUpdate run{extraction_, loaded, dataset,    stop,           *geometry,        cuts_,    boundaries_, volumes_,
                    camera,      moving, most_bytes, memory_bytes(), capping(checked), direction};
    const auto visible =
        std::count_if(scene.layers.begin(), scene.layers.end(), [](const auto& one) { return one.visible; });
    std::size_t done = 0;
    const auto tell = [&] {
        if (layers_made) layers_made(done, static_cast<std::size_t>(visible));
    };
    for (const scene::Layer& layer : scene.layers) {
        if (!layer.visible) continue;
        tell();
        const auto make = [&](const auto& kind) { return run(layer, kind); };
        if (!dataset->naming_changed_file([&] { return std::visit(make, layer.kind); })) return nullptr;
        ++done;
    }
    tell();
    const std::vector<EmptyLayer> empty = empty_layers(*geometry, checked);
    geometry->empty.insert(geometry->empty.end(), empty.begin(), empty.end());
    const auto is_late = [](const auto& array) { return array.second.late; };
    if (std::ranges::any_of(step.arrays, is_late) && loaded->dataset() != dataset && geometry->awaited.empty())
        geometry->awaited = "the step has just been read from its source"; // `dataset` does not have its ranges yet
    dataset->check_intact();
    geometry->bytes = memory_bytes();
    return geometry;
}

void SceneGeometry::forget_all() {
    cuts_.clear();
    boundaries_.clear();
    volumes_.clear();
}

void SceneGeometry::forget_all_but(const scene::CheckedScene& checked) {
    std::map<std::string, std::size_t> cuts_of; // by layer: number of cuts to keep
    std::set<std::string> shown;
    const std::size_t caps = capping(checked).size();
    for (const scene::Layer& layer : checked.scene().layers) {
        const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind);
        const auto* surface = std::get_if<scene::SurfaceLayer>(&layer.kind);
        if (layer.visible) shown.insert(layer.id);
        if (!layer.visible)
            cuts_of[layer.id] = SIZE_MAX; // keeps all, so that showing the layer again needs no cut
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

} // namespace server::geometry
