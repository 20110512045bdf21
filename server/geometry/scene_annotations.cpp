#include "geometry/scene_annotations.hpp"

#include "annotations/legend_names.hpp"
#include "annotations/ticks.hpp"
#include "scene/rules.hpp"

namespace server::geometry {
namespace {

template <class Shown>
annotations::Legend legend_of(const Shown& drawable, bool missing) {
    return {drawable.array, drawable.units, drawable.scale, {}, missing, drawable.legend_lines};
}

annotations::NamedLayer named_layer(const scene::Layer& layer, bool contours) {
    annotations::NamedLayer named{std::visit([](const auto& kind) { return std::string(kind.type); }, layer.kind),
                                  contours};
    if (const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind)) named.array = iso->array;
    if (const auto* surface = std::get_if<scene::SurfaceLayer>(&layer.kind)) named.groups = surface->groups;
    if (const auto* slice = std::get_if<scene::SliceLayer>(&layer.kind)) {
        const scene::Plane plane = plane_of(*slice);
        named.origin = plane.origin;
        named.normal = plane.normal;
    }
    return named;
}

class Legends {
public:
    void add(const scene::Layer& layer, const annotations::Legend& legend, bool contours) {
        std::size_t i = 0;
        while (i < legends.size() && !(legends[i].name == legend.name && legends[i].scale == legend.scale)) ++i;
        if (i == legends.size()) {
            named_.push_back({legend.name, {}});
            legends.push_back(legend);
        }
        legends[i].missing = legends[i].missing || legend.missing;
        named_[i].names.push_back(annotations::legend_name_of(named_layer(layer, contours)));
    }
    void tell_apart() {
        const std::vector<std::string> names = annotations::legend_names(named_);
        for (std::size_t i = 0; i < legends.size(); ++i) legends[i].layers = names[i];
    }
    std::vector<annotations::Legend> legends;

private:
    std::vector<annotations::NamedLegend> named_; // one per legend
};

std::vector<annotations::Legend> legends_of(const Geometry& geometry, const std::vector<scene::Layer>& layers,
                                            LegendsOf wanted) {
    Legends found;
    for (const scene::Layer& layer : layers) {
        if (wanted == LegendsOf::what_is_seen && is_empty(geometry, layer.id)) continue;
        for (const Drawable& drawable : geometry.drawables)
            if (drawable.layer == layer.id && drawable.scalars)
                found.add(layer, legend_of(drawable, drawable.missing), drawable.contours);
        // A volume has no missing values, because cells without values are left out.
        for (const VolumeDrawable& volume : geometry.volumes)
            if (volume.layer == layer.id) found.add(layer, legend_of(volume, false), false);
    }
    found.tell_apart();
    return std::move(found.legends);
}

} // namespace

annotations::Annotations annotations_of(const Geometry& geometry, const scene::CheckedScene& checked,
                                        LegendsOf legends) {
    const scene::Scene& scene = checked.scene();
    const scene::Annotations& wanted = scene.annotations;
    annotations::Annotations annotations;
    annotations.title = wanted.title;
    if (wanted.dataset) annotations.captions.push_back(scene.dataset);
    if (wanted.time) annotations.captions.push_back("Time: " + annotations::number_label(geometry.time));
    if (wanted.legend) annotations.legends = legends_of(geometry, scene.layers, legends);
    annotations.triad = wanted.triad;
    annotations.axes = wanted.axes;
    annotations.length_units = geometry.length_units;
    annotations.scale = wanted.scale;
    return annotations;
}

} // namespace server::geometry
