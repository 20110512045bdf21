#include "scene/scene.hpp"
#include "scene/schema.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

namespace ciel::scene {
namespace {

using nlohmann::json;
using Point = std::array<double, 3>;

template <class T>
void read(const json& object, const char* name, T& out) {
    if (const auto member = object.find(name); member != object.end() && !member->is_null()) member->get_to(out);
}

std::array<float, 3> color_of(const std::string& hex) {
    const auto channel = [&](std::size_t at) {
        return static_cast<float>(std::stoi(hex.substr(at, 2), nullptr, 16)) / 255.0F;
    };
    return {channel(1), channel(3), channel(5)};
}

Camera camera_of(const json& object) {
    Camera camera;
    read(object, "position", camera.position);
    read(object, "target", camera.target);
    read(object, "up", camera.up);
    read(object, "fov", camera.fov);
    read(object, "parallel", camera.parallel);
    read(object, "parallel_height", camera.parallel_height);
    if (camera.position == camera.target)
        throw Invalid("/camera/position", "the camera's position and target must differ");
    if (camera.up == Point{}) throw Invalid("/camera/up", "the camera's up direction must not be zero");
    if (camera.parallel && !object.contains("parallel_height"))
        throw Invalid("/camera/parallel_height", "a parallel camera needs parallel_height, the height of the view");
    return camera;
}

Coloring coloring_of(const json& layer, const std::string& path) {
    Coloring coloring;
    const auto color = layer.find("color");
    if (color == layer.end()) return coloring;
    read(*color, "array", coloring.array);
    read(*color, "map", coloring.map);
    if (const auto range = color->find("range"); range != color->end() && !range->is_null()) {
        coloring.range = range->get<std::array<double, 2>>();
        if ((*coloring.range)[0] > (*coloring.range)[1])
            throw Invalid(path + "/color/range", "a range is [minimum, maximum]");
    }
    if (const auto solid = color->find("solid"); solid != color->end()) coloring.solid = color_of(*solid);
    return coloring;
}

IsoLayer iso_of(const json& object, const std::string& path) {
    IsoLayer iso;
    read(object, "array", iso.array);
    read(object, "values", iso.values);
    read(object, "smooth", iso.smooth);
    iso.color = coloring_of(object, path);
    return iso;
}

SliceLayer slice_of(const json& object, const std::string& path) {
    SliceLayer slice;
    slice.color = coloring_of(object, path);
    const bool by_axis = object.contains("axis") && object.contains("value");
    const bool by_plane = object.contains("origin") && object.contains("normal");
    const bool mixed = object.contains("axis") || object.contains("value")
                           ? object.contains("origin") || object.contains("normal")
                           : false;
    if (by_axis == by_plane || mixed) throw Invalid(path, "a slice has either axis and value, or origin and normal");
    if (by_axis) {
        const auto axis = static_cast<std::size_t>(object["axis"].get_ref<const std::string&>()[0] - 'x');
        slice.normal = {};
        slice.normal[axis] = 1;
        slice.origin[axis] = object["value"].get<double>();
        return slice;
    }
    read(object, "origin", slice.origin);
    read(object, "normal", slice.normal);
    const double length = std::hypot(slice.normal[0], slice.normal[1], slice.normal[2]);
    if (!(length > 0) || !std::isfinite(length)) throw Invalid(path + "/normal", "a slice's normal must not be zero");
    for (double& component : slice.normal) component /= length;
    return slice;
}

SurfaceLayer surface_of(const json& object, const std::string& path) {
    SurfaceLayer surface;
    read(object, "groups", surface.groups);
    surface.color = coloring_of(object, path);
    return surface;
}

OutlineLayer outline_of(const json& object, const std::string& path) { return {coloring_of(object, path)}; }

void check_opacity_points(const VolumeLayer& volume, const std::string& path) {
    for (std::size_t i = 0; i < volume.opacity_points.size(); ++i) {
        const auto& [place, opacity] = volume.opacity_points[i];
        const std::string at = path + "/opacity_points/" + std::to_string(i);
        if (!(place >= 0 && place <= 1 && opacity >= 0 && opacity <= 1))
            throw Invalid(at, "an opacity point is [position, opacity], each from 0 to 1");
        if (i > 0 && place < volume.opacity_points[i - 1][0])
            throw Invalid(at, "opacity points must be in the order of their positions");
    }
}

VolumeLayer volume_of(const json& object, const std::string& path) {
    static const std::map<std::string, VolumeLayer::Direction> directions{{"auto", VolumeLayer::Direction::automatic},
                                                                          {"x", VolumeLayer::Direction::x},
                                                                          {"y", VolumeLayer::Direction::y},
                                                                          {"z", VolumeLayer::Direction::z},
                                                                          {"screen", VolumeLayer::Direction::screen}};
    VolumeLayer volume;
    read(object, "array", volume.array);
    volume.color = coloring_of(object, path);
    read(object, "opacity_points", volume.opacity_points);
    check_opacity_points(volume, path);
    if (const auto length = object.find("unit_length"); length != object.end() && !length->is_null())
        volume.unit_length = length->get<double>();
    read(object, "slices", volume.slices);
    if (const auto direction = object.find("direction"); direction != object.end())
        volume.direction = directions.at(direction->get<std::string>());
    read(object, "shaded", volume.shaded);
    if (!volume.color.array.empty() && volume.color.array != volume.array)
        throw Invalid(path + "/color/array", "a volume has the colours of its own array, " + volume.array);
    return volume;
}

using Kind = decltype(Layer::kind);
const std::map<std::string, Kind (*)(const json&, const std::string&)> kinds{
    {"iso", [](const json& o, const std::string& p) -> Kind { return iso_of(o, p); }},
    {"slice", [](const json& o, const std::string& p) -> Kind { return slice_of(o, p); }},
    {"surface", [](const json& o, const std::string& p) -> Kind { return surface_of(o, p); }},
    {"outline", [](const json& o, const std::string& p) -> Kind { return outline_of(o, p); }},
    {"volume", [](const json& o, const std::string& p) -> Kind { return volume_of(o, p); }},
};

Layer layer_of(const std::string& id, const json& object) {
    Layer layer;
    layer.id = id;
    read(object, "order", layer.order);
    read(object, "visible", layer.visible);
    read(object, "opacity", layer.opacity);
    layer.kind = kinds.at(object["type"])(object, pointer_step("/layers", id));
    return layer;
}

} // namespace

Scene parse(const json& document) {
    static const json& schema = contract().at("components").at("schemas").at("Scene");
    if (const auto violation = check_schema(schema, document))
        throw Invalid(violation->path,
                      (violation->path.empty() ? "the scene" : violation->path) + " " + violation->reason);

    Scene scene;
    read(document, "dataset", scene.dataset);
    read(document, "time", scene.time);
    read(document, "background", scene.background);
    read(document, "legend", scene.legend);
    if (const auto camera = document.find("camera"); camera != document.end() && !camera->is_null())
        scene.camera = camera_of(*camera);
    if (const auto layers = document.find("layers"); layers != document.end())
        for (const auto& [id, layer] : layers->items()) scene.layers.push_back(layer_of(id, layer));
    std::sort(scene.layers.begin(), scene.layers.end(),
              [](const Layer& a, const Layer& b) { return std::tie(a.order, a.id) < std::tie(b.order, b.id); });
    return scene;
}

} // namespace ciel::scene
