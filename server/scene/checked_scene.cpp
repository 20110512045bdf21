#include "scene/checked_scene.hpp"

#include "ciel/printable.hpp"
#include "color/color_map.hpp"
#include "scene/contract.hpp"

#include <algorithm>

namespace server::scene {
namespace {

struct Check {
    const store::Dataset& dataset;
    std::string path; // JSON pointer of the layer

    // `why_points`: reason to refuse cell arrays, or empty. `has_faces`: arrays on boundary faces are allowed.
    void scalar(const std::string& name, const std::string& place, const char* why_points,
                bool has_faces = false) const {
        try {
            const store::ScalarName parsed = store::parse_scalar(dataset, name);
            const store::Association association = dataset.find(parsed.array)->association;
            if (association == store::Association::boundary_face && !has_faces)
                throw ciel::Error(ciel::printable(name) +
                                  " has values only on the faces of patches, which can color surface "
                                  "layers only; choose an array on points");
            if (*why_points != '\0' && association == store::Association::cell)
                throw ciel::Error(ciel::printable(name) + " has a value per cell, and " + why_points +
                                  "; choose an array on points");
        } catch (const ciel::Error& error) {
            throw Invalid(path + place, error.what());
        }
    }

    void coloring(const Coloring& color, const char* why_points = "", const std::string& place = "/color",
                  bool has_faces = false) const {
        if (!color.array.empty()) scalar(color.array, place + "/array", why_points, has_faces);
        const auto& maps = color::color_map_names();
        if (std::find(maps.begin(), maps.end(), color.map) != maps.end()) return;
        std::string known;
        for (const auto& name : maps) known += (known.empty() ? "" : ", ") + name;
        throw Invalid(path + place + "/map",
                      "there is no color map " + ciel::printable(color.map) + "; choose one of " + known);
    }

    void operator()(const IsoLayer& iso) const {
        scalar(iso.array, "/array", "iso-surfaces are made from values at points");
        coloring(iso.color);
    }
    void operator()(const SliceLayer& slice) const {
        coloring(slice.color);
        if (!slice.contours) return;
        constexpr const char* why = "contour lines are made from values at points";
        scalar(slice.contours->array, "/contours/array", why);
        if (slice.contours->coloring) coloring(*slice.contours->coloring, why, "/contours/coloring");
    }
    void operator()(const ClipLayer& clip) const {
        if (clip.color) coloring(*clip.color);
    }
    void operator()(const OutlineLayer& outline) const { coloring(outline.color); }
    void operator()(const VolumeLayer& volume) const {
        constexpr const char* why = "volumes are drawn from values at points";
        scalar(volume.array, "/array", why);
        coloring(volume.color, why);
    }
    void operator()(const SurfaceLayer& surface) const { solid(surface, "", true); }
    void operator()(const EdgesLayer& edges) const { solid(edges, "edges take values at points"); }
    void operator()(const PointsLayer& points) const { solid(points, "points take values at points"); }

    template <class Kind>
    void solid(const Kind& layer, const char* why_points, bool has_faces = false) const {
        coloring(layer.color, why_points, "/color", has_faces);
        if (layer.threshold) scalar(layer.threshold->array, "/threshold/array", "");
        for (std::size_t i = 0; i < layer.groups.size(); ++i) patch(layer.groups[i], i);
    }

    void patch(const std::string& name, std::size_t index) const {
        std::string known;
        for (std::size_t mesh = 0; mesh < dataset.info().meshes.size(); ++mesh)
            for (const store::Group& group : dataset.groups(mesh)) {
                if (group.of != store::Group::Of::faces) continue;
                if (group.name == name) return;
                known += (known.empty() ? "" : ", ") + group.name;
            }
        throw Invalid(path + "/groups/" + std::to_string(index),
                      "there is no patch " + ciel::printable(name) +
                          (known.empty() ? "; the dataset has no patches" : "; choose one of " + known));
    }
};

} // namespace

CheckedScene::CheckedScene(Scene scene, std::shared_ptr<store::LoadedDataset> loaded)
    : scene_(std::move(scene)), loaded_(std::move(loaded)), dataset_(loaded_->dataset()) {
    for (const Layer& layer : scene_.layers)
        std::visit(Check{*dataset_, pointer_step("/layers", layer.id)}, layer.kind);
}

CheckedScene CheckedScene::with_camera(const Camera& camera) const {
    CheckedScene changed = *this;
    changed.scene_.camera = camera;
    return changed;
}

} // namespace server::scene
