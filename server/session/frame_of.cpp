#include "render/annotations/make_room.hpp"
#include "render/renderer.hpp"
#include "session/annotations.hpp"
#include "session/clip.hpp"
#include "session/scene_geometry.hpp"
#include "session/volume_cut.hpp"

#include <algorithm>
#include <cmath>

namespace ciel::session {
namespace {

struct Background {
    std::array<float, 3> top, bottom;
};

Background background_of(const std::string& name) {
    if (name == "dark") return {{0.10F, 0.12F, 0.16F}, {0.03F, 0.04F, 0.05F}};
    if (name == "light") return {{1.0F, 1.0F, 1.0F}, {0.90F, 0.92F, 0.95F}};
    std::array<float, 3> color{};
    for (std::size_t i = 0; i < 3; ++i)
        color[i] = static_cast<float>(std::stoi(name.substr(1 + 2 * i, 2), nullptr, 16)) / 255.0F;
    return {color, color};
}

render::Lighting lighting_of(const scene::Lighting& lighting) {
    const auto strength = [](const scene::Light& light) { return light.on ? light.strength : 0; };
    return {lighting.ambient, strength(lighting.headlight), strength(lighting.key_light)};
}

render::Occlusion occlusion_of(const scene::Lighting& lighting, const Geometry& geometry) {
    const scene::AmbientOcclusion& occlusion = lighting.ambient_occlusion;
    if (!lighting.on || !occlusion.on) return {};
    double square = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
        square += std::pow(geometry.bounds_max[axis] - geometry.bounds_min[axis], 2);
    return {occlusion.radius * std::sqrt(square), occlusion.strength};
}

render::Volume volume_of(const VolumeDrawable& drawable, const render::Lighting& lighting) {
    render::Volume volume;
    volume.slices = drawable.slabs->slices;
    volume.boundary = drawable.slabs->boundary.get();
    volume.normal = drawable.slabs->normal;
    volume.first = drawable.slabs->first;
    volume.thickness = drawable.slabs->thickness;
    volume.stride = drawable.stride;
    volume.scale = drawable.scale;
    volume.opacity_points = drawable.opacity_points;
    volume.unit_length = drawable.unit_length;
    volume.shaded = drawable.shaded && lighting.headlight > 0;
    volume.opacity = drawable.opacity;
    volume.coarseness = drawable.stride > 1 ? 2 : 1;
    volume.identity = drawable.identity;
    volume.revision = drawable.revision;
    return volume;
}

// Frames look from where the scene's pictures do, whether they are written on or not: a pixel of one is the same pixel
// of the other.
render::Camera beside_annotations(render::Frame frame, const Geometry& geometry, const scene::Scene& scene) {
    frame.annotations = annotations_of(geometry, scene, LegendsOf::all_layers);
    return render::clear_of_annotations(frame);
}

} // namespace

render::Camera camera_of(const Geometry& geometry, const scene::Scene& scene, double aspect) {
    if (!scene.camera) return render::default_camera(geometry.bounds_min, geometry.bounds_max, aspect);
    const scene::Camera& camera = *scene.camera;
    return {camera.position, camera.target, camera.up, camera.fov, camera.parallel, camera.parallel_height};
}

render::Camera default_view(const Geometry& geometry, const scene::Scene& scene, int width, int height,
                            double fov_degrees, bool parallel, const std::optional<BoundingBox>& of) {
    render::Frame frame;
    frame.width = width;
    frame.height = height;
    frame.bounds_min = of ? of->low : geometry.bounds_min;
    frame.bounds_max = of ? of->high : geometry.bounds_max;
    frame.camera =
        render::default_camera(frame.bounds_min, frame.bounds_max, static_cast<double>(width) / height, fov_degrees);
    frame.camera.parallel = parallel;
    return beside_annotations(std::move(frame), geometry, scene);
}

render::Frame frame_of(const Geometry& geometry, const scene::Scene& scene, int width, int height, int samples) {
    render::Frame frame;
    frame.width = width;
    frame.height = height;
    frame.samples = samples;
    frame.origin = geometry.origin;
    frame.camera = scene.camera ? camera_of(geometry, scene, static_cast<double>(width) / height)
                                : default_view(geometry, scene, width, height);
    frame.bounds_min = geometry.bounds_min;
    frame.bounds_max = geometry.bounds_max;
    frame.clip = shader_planes(geometry);
    const Background background = background_of(scene.background);
    frame.background_top = background.top;
    frame.background_bottom = background.bottom;
    frame.lighting = scene.lighting.on ? lighting_of(scene.lighting) : render::Lighting{0, 0, 0};
    frame.occlusion = occlusion_of(scene.lighting, geometry);
    for (const Drawable& drawable : geometry.drawables) {
        render::Mesh mesh;
        mesh.positions = drawable.shape->surface.positions;
        if (drawable.polygons()) mesh.normals = drawable.shape->surface.normals;
        if (drawable.scalars) mesh.scalars = *drawable.scalars;
        mesh.indices = drawable.indices();
        mesh.lines = drawable.lines();
        mesh.points = drawable.points();
        mesh.line_width = mesh.point_size = drawable.line_width;
        mesh.on_opaque = drawable.is_on_surface() && drawable.color[3] >= 1;
        mesh.scale = drawable.scale;
        mesh.color = drawable.color;
        mesh.revision = drawable.revision;
        mesh.identity = drawable.identity;
        mesh.lit = drawable.lit && scene.lighting.on;
        frame.meshes.push_back(std::move(mesh));
    }
    for (const VolumeDrawable& drawable : geometry.volumes)
        frame.volumes.push_back(volume_of(drawable, frame.lighting));
    std::stable_partition(frame.meshes.begin(), frame.meshes.end(),
                          [](const render::Mesh& mesh) { return mesh.color[3] >= 1; });
    return frame;
}

} // namespace ciel::session
