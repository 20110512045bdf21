#include "session/annotations.hpp"

#include "render/ticks.hpp"

#include <algorithm>

namespace ciel::session {
namespace {

template <class Shown>
render::Legend legend_of(const Shown& drawable) {
    return {drawable.array, drawable.units, drawable.scale};
}

bool is_same(const render::Legend& a, const render::Legend& b) { return a.name == b.name && a.scale == b.scale; }

std::vector<render::Legend> legends_of(const Geometry& geometry) {
    std::vector<render::Legend> legends;
    const auto add = [&](const render::Legend& legend) {
        const auto same = [&](const render::Legend& other) { return is_same(legend, other); };
        if (std::none_of(legends.begin(), legends.end(), same)) legends.push_back(legend);
    };
    for (const Drawable& drawable : geometry.drawables)
        if (drawable.scalars) add(legend_of(drawable));
    for (const VolumeDrawable& volume : geometry.volumes) add(legend_of(volume));
    return legends;
}

} // namespace

render::Annotations annotations_of(const Geometry& geometry, const scene::Scene& scene) {
    const scene::Annotations& wanted = scene.annotations;
    render::Annotations annotations;
    annotations.title = wanted.title;
    if (wanted.dataset) annotations.captions.push_back(scene.dataset);
    if (wanted.time) annotations.captions.push_back("Time: " + render::number_label(geometry.time));
    if (wanted.legend) annotations.legends = legends_of(geometry);
    annotations.triad = wanted.triad;
    annotations.axes = wanted.axes;
    annotations.length_units = geometry.length_units;
    annotations.scale = wanted.scale;
    return annotations;
}

} // namespace ciel::session
