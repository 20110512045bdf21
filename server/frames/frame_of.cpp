#include "frames/frame_of.hpp"

#include "color/background.hpp"
#include "geometry/clip.hpp"
#include "geometry/viewpoint.hpp"
#include "geometry/volume_cut.hpp"
#include "scene/rules.hpp"

#include <algorithm>
#include <cmath>

namespace server::frames {
namespace {

static_assert(render::most_clip_planes >= scene::most_clip_planes);

color::Background background_of(const std::variant<scene::Scene::Background, scene::Color>& background) {
    if (const auto* color = std::get_if<scene::Color>(&background))
        return {color::floats_of(*color), color::floats_of(*color)};
    if (std::get<scene::Scene::Background>(background) == scene::Scene::Background::light)
        return color::light_background;
    return color::dark_background;
}

render::Lighting lighting_of(const scene::Lighting& lighting) {
    const auto strength = [](const scene::Light& light) { return light.on ? light.strength : 0; };
    return {lighting.ambient, strength(lighting.headlight), strength(lighting.key_light)};
}

render::Occlusion occlusion_of(const scene::Lighting& lighting, const geometry::Geometry& geometry) {
    const scene::AmbientOcclusion& occlusion = lighting.ambient_occlusion;
    if (!lighting.on || !occlusion.on) return {};
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        square += std::pow(geometry.bounds_max[axis] - geometry.bounds_min[axis], 2);
    return {occlusion.radius * std::sqrt(square), occlusion.strength};
}

render::Volume volume_of(const geometry::VolumeDrawable& drawable, const render::Lighting& lighting) {
    render::Volume volume;
    volume.slices = drawable.slabs->slices;
    volume.boundary = drawable.slabs->boundary.get();
    volume.normal = drawable.slabs->normal;
    volume.first = drawable.slabs->first;
    volume.thickness = drawable.slabs->thickness;
    volume.stride = drawable.stride;
    volume.scale = drawable.scale; // always linear, so that values and range may be relative to an origin
    for (double& end : volume.scale.range) end -= drawable.value_origin;
    volume.opacity_points = drawable.opacity_points;
    volume.unit_length = drawable.unit_length;
    volume.shaded = drawable.shaded && lighting.headlight > 0;
    volume.opacity = drawable.opacity;
    volume.coarseness = drawable.stride > 1 ? 2 : 1;
    volume.identity = drawable.identity;
    volume.revision = drawable.revision;
    return volume;
}

} // namespace

render::Frame frame_of(const geometry::Geometry& geometry, const scene::CheckedScene& checked, int width, int height,
                       int samples) {
    const scene::Scene& scene = checked.scene();
    render::Frame frame;
    static_cast<annotations::Viewpoint&>(frame) = geometry::viewpoint_of(geometry, checked, width, height);
    frame.samples = samples;
    frame.clip = geometry::shader_planes(geometry);
    const color::Background background = background_of(scene.background);
    frame.background_top = background.top;
    frame.background_bottom = background.bottom;
    frame.lighting = scene.lighting.on ? lighting_of(scene.lighting) : render::Lighting{0, 0, 0};
    frame.occlusion = occlusion_of(scene.lighting, geometry);
    for (const geometry::Drawable& drawable : geometry.drawables) {
        render::Primitives primitives;
        primitives.positions = drawable.shape->surface.positions;
        if (drawable.polygons()) primitives.normals = drawable.shape->surface.normals;
        if (drawable.scalars) primitives.scalars = *drawable.scalars;
        primitives.scalar_origin = drawable.scalar_origin;
        primitives.indices = drawable.indices();
        primitives.lines = drawable.lines();
        primitives.points = drawable.points();
        primitives.line_width = primitives.point_size = drawable.line_width;
        primitives.on_opaque = drawable.is_on_surface() && drawable.color[3] >= 1;
        primitives.scale = drawable.scale;
        primitives.color = drawable.color;
        primitives.revision = drawable.revision;
        primitives.identity = drawable.identity;
        primitives.lit = drawable.lit && scene.lighting.on;
        frame.primitives.push_back(std::move(primitives));
    }
    for (const geometry::VolumeDrawable& drawable : geometry.volumes)
        frame.volumes.push_back(volume_of(drawable, frame.lighting));
    std::stable_partition(frame.primitives.begin(), frame.primitives.end(),
                          [](const render::Primitives& primitives) { return primitives.color[3] >= 1; });
    return frame;
}

} // namespace server::frames
