#include "ciel/printable.hpp"
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

Rgb8 bytes_of(const std::string& hex) {
    const auto channel = [&](std::size_t at) {
        return static_cast<std::uint8_t>(std::stoi(hex.substr(at, 2), nullptr, 16));
    };
    return {channel(1), channel(3), channel(5)};
}

std::array<float, 3> color_of(const std::string& hex) {
    const Rgb8 bytes = bytes_of(hex);
    return {static_cast<float>(bytes[0]) / 255.0F, static_cast<float>(bytes[1]) / 255.0F,
            static_cast<float>(bytes[2]) / 255.0F};
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

// `name` of `object`, a range or null.
std::optional<std::array<double, 2>> range_of(const json& object, const char* name, const std::string& path) {
    const auto member = object.find(name);
    if (member == object.end() || member->is_null()) return {};
    const auto range = member->get<std::array<double, 2>>();
    if (range[0] > range[1]) throw Invalid(path + "/" + name, "a range is [minimum, maximum]");
    return range;
}

std::optional<Rgb8> read_color(const json& object, const char* name) {
    const auto member = object.find(name);
    if (member == object.end() || member->is_null()) return {};
    return bytes_of(*member);
}

std::vector<ColorPoint> color_points_of(const json& color, const std::string& path) {
    std::vector<ColorPoint> points;
    const auto given = color.find("points");
    if (given == color.end() || given->is_null()) return points;
    for (const json& point : *given) {
        const double at = point["at"];
        if (!points.empty() && at < points.back().at)
            throw Invalid(path + "/points/" + std::to_string(points.size()) + "/at",
                          "the points of a color map stand in ascending order of at");
        points.push_back({at, bytes_of(point["color"])});
    }
    return points;
}

// Refuses a given range that reaches zero or below on a logarithmic scale.
void check_scale(const Coloring& coloring, const std::string& path) {
    if (!coloring.log || coloring.symmetric) return;
    if (coloring.range && (*coloring.range)[0] <= 0)
        throw Invalid(path + "/range", "a logarithmic scale has no place for zero and below; give a range that "
                                       "begins above zero, add symmetric, or leave out log");
}

Coloring coloring_of(const json& layer, const std::string& layer_path, const char* member = "color") {
    Coloring coloring;
    const auto color = layer.find(member);
    if (color == layer.end()) return coloring;
    const std::string path = layer_path + "/" + member;
    read(*color, "array", coloring.array);
    read(*color, "map", coloring.map);
    read(*color, "reverse", coloring.reverse);
    read(*color, "symmetric", coloring.symmetric);
    read(*color, "log", coloring.log);
    read(*color, "steps", coloring.steps);
    coloring.nan = read_color(*color, "nan").value_or(coloring.nan);
    coloring.below = read_color(*color, "below");
    coloring.above = read_color(*color, "above");
    coloring.points = color_points_of(*color, path);
    coloring.range = range_of(*color, "range", path);
    check_scale(coloring, path);
    if (const auto solid = color->find("solid"); solid != color->end()) coloring.solid = color_of(*solid);
    return coloring;
}

void read_lines(const json& object, LineStyle& style) {
    if (const auto color = object.find("color"); color != object.end()) style.color = color_of(*color);
    read(object, "width", style.width);
}

bool is_shown(const json& layer, const char* name) {
    const auto member = layer.find(name);
    return member != layer.end() && member->value("visible", true);
}

std::optional<LineStyle> edges_of(const json& layer) {
    if (!is_shown(layer, "edges")) return {};
    LineStyle style;
    read_lines(layer["edges"], style);
    return style;
}

std::optional<Contours> contours_of(const json& layer, const std::string& path) {
    if (!is_shown(layer, "contours")) return {};
    const json& object = layer["contours"];
    if (object.contains("values") && (object.contains("count") || object.contains("range")))
        throw Invalid(path + "/contours", "contours have either values, or count and range");
    Contours contours;
    read(object, "array", contours.array);
    read(object, "values", contours.values);
    if (object.contains("values")) contours.count = 0;
    read(object, "count", contours.count);
    contours.range = range_of(object, "range", path + "/contours");
    read_lines(object, contours.line);
    if (!object.contains("coloring")) return contours;
    contours.coloring = coloring_of(object, path + "/contours", "coloring");
    if (std::string& array = contours.coloring->array; array.empty())
        array = contours.array;
    else if (array != contours.array)
        throw Invalid(path + "/contours/coloring/array", "contour lines of " + printable(contours.array) +
                                                             " have the colors of its values, not of " +
                                                             printable(array) + "; leave out the array of the colors");
    return contours;
}

IsoLayer iso_of(const json& object, const std::string& path) {
    IsoLayer iso;
    read(object, "array", iso.array);
    read(object, "values", iso.values);
    read(object, "smooth", iso.smooth);
    iso.color = coloring_of(object, path);
    iso.edges = edges_of(object);
    return iso;
}

struct Plane {
    Point origin{}, normal{};
};

// `what`: the kind of layer for messages, such as "slice".
Plane plane_of(const json& object, const std::string& path, const std::string& what) {
    Plane plane;
    const bool by_axis = object.contains("axis") && object.contains("value");
    const bool by_plane = object.contains("origin") && object.contains("normal");
    const bool mixed = object.contains("axis") || object.contains("value")
                           ? object.contains("origin") || object.contains("normal")
                           : false;
    if (by_axis == by_plane || mixed)
        throw Invalid(path, "a " + what + " has either axis and value, or origin and normal");
    if (by_axis) {
        const auto axis = static_cast<std::size_t>(object["axis"].get_ref<const std::string&>()[0] - 'x');
        plane.normal[axis] = 1;
        plane.origin[axis] = object["value"].get<double>();
        return plane;
    }
    read(object, "origin", plane.origin);
    read(object, "normal", plane.normal);
    const double length = std::hypot(plane.normal[0], plane.normal[1], plane.normal[2]);
    if (!(length > 0) || !std::isfinite(length))
        throw Invalid(path + "/normal", "a " + what + "'s normal must not be zero");
    for (double& component : plane.normal) component /= length;
    return plane;
}

SliceLayer slice_of(const json& object, const std::string& path) {
    SliceLayer slice;
    slice.color = coloring_of(object, path);
    slice.contours = contours_of(object, path);
    slice.edges = edges_of(object);
    const Plane plane = plane_of(object, path, "slice");
    slice.origin = plane.origin;
    slice.normal = plane.normal;
    return slice;
}

ClipLayer clip_of(const json& object, const std::string& path) {
    ClipLayer clip;
    const Plane plane = plane_of(object, path, "clip");
    clip.origin = plane.origin;
    clip.normal = plane.normal;
    if (object.value("invert", false))
        for (double& component : clip.normal) component = -component;
    read(object, "caps", clip.caps);
    if (const auto color = object.find("color"); color != object.end()) clip.color = coloring_of(object, path);
    return clip;
}

std::optional<Threshold> threshold_of(const json& layer, const std::string& path) {
    const auto member = layer.find("threshold");
    if (member == layer.end() || !member->value("enabled", true)) return {};
    Threshold threshold;
    read(*member, "array", threshold.array);
    threshold.range = *range_of(*member, "range", path + "/threshold");
    threshold.any = member->value("keep", "all") == "any";
    return threshold;
}

EdgesLayer edges_layer_of(const json& object, const std::string& path) {
    EdgesLayer edges;
    read(object, "groups", edges.groups);
    edges.threshold = threshold_of(object, path);
    if (object.contains("angle")) edges.angle = object["angle"].get<double>();
    read(object, "width", edges.width);
    edges.color = coloring_of(object, path);
    return edges;
}

PointsLayer points_of(const json& object, const std::string& path) {
    PointsLayer points;
    points.all = object.value("of", "boundary") == "all";
    read(object, "groups", points.groups);
    if (points.all && !points.groups.empty())
        throw Invalid(path + "/groups",
                      "patches have points of the boundary only; leave out groups or \"of\": \"all\"");
    points.threshold = threshold_of(object, path);
    read(object, "size", points.size);
    read(object, "most", points.most);
    points.color = coloring_of(object, path);
    return points;
}

SurfaceLayer surface_of(const json& object, const std::string& path) {
    SurfaceLayer surface;
    read(object, "groups", surface.groups);
    surface.color = coloring_of(object, path);
    surface.threshold = threshold_of(object, path);
    surface.edges = edges_of(object);
    return surface;
}

OutlineLayer outline_of(const json& object, const std::string& path) { return {coloring_of(object, path)}; }

// Counts bytes, since the contract's maxLength counts characters of up to four bytes.
void check_name(const std::string& name, const std::string& path, const char* what) {
    if (name.size() > most_name_bytes)
        throw Invalid(path, std::string(what) + " may have at most " + std::to_string(most_name_bytes) +
                                " bytes of UTF-8; shorten it");
}

Annotations annotations_of(const json& object) {
    Annotations annotations;
    read(object, "legend", annotations.legend);
    read(object, "triad", annotations.triad);
    read(object, "axes", annotations.axes);
    read(object, "time", annotations.time);
    read(object, "dataset", annotations.dataset);
    read(object, "title", annotations.title);
    check_name(annotations.title, "/annotations/title", "a title");
    read(object, "scale", annotations.scale);
    return annotations;
}

Light light_of(const json& lighting, const char* name) {
    Light light;
    if (const auto object = lighting.find(name); object != lighting.end()) {
        read(*object, "on", light.on);
        read(*object, "strength", light.strength);
    }
    return light;
}

Lighting lighting_of(const json& object) {
    Lighting lighting;
    read(object, "on", lighting.on);
    read(object, "ambient", lighting.ambient);
    lighting.headlight = light_of(object, "headlight");
    lighting.key_light = light_of(object, "key_light");
    if (const auto occlusion = object.find("ambient_occlusion"); occlusion != object.end()) {
        read(*occlusion, "on", lighting.ambient_occlusion.on);
        read(*occlusion, "radius", lighting.ambient_occlusion.radius);
        read(*occlusion, "strength", lighting.ambient_occlusion.strength);
    }
    return lighting;
}

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
    if (const auto slices = object.find("slices"); slices != object.end() && !slices->is_null())
        volume.slices = slices->get<std::size_t>();
    if (const auto direction = object.find("direction"); direction != object.end())
        volume.direction = directions.at(direction->get<std::string>());
    read(object, "shaded", volume.shaded);
    if (!volume.color.array.empty() && volume.color.array != volume.array)
        throw Invalid(path + "/color/array", "a volume has the colors of its own array, " + printable(volume.array));
    return volume;
}

using Kind = decltype(Layer::kind);
const std::map<std::string, Kind (*)(const json&, const std::string&)> kinds{
    {"iso", [](const json& o, const std::string& p) -> Kind { return iso_of(o, p); }},
    {"slice", [](const json& o, const std::string& p) -> Kind { return slice_of(o, p); }},
    {"surface", [](const json& o, const std::string& p) -> Kind { return surface_of(o, p); }},
    {"outline", [](const json& o, const std::string& p) -> Kind { return outline_of(o, p); }},
    {"edges", [](const json& o, const std::string& p) -> Kind { return edges_layer_of(o, p); }},
    {"points", [](const json& o, const std::string& p) -> Kind { return points_of(o, p); }},
    {"clip", [](const json& o, const std::string& p) -> Kind { return clip_of(o, p); }},
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

void check_clip_planes(const std::vector<Layer>& layers) {
    std::size_t planes = 0;
    for (const Layer& layer : layers)
        if (layer.visible && std::holds_alternative<ClipLayer>(layer.kind) && ++planes > most_clip_planes)
            throw Invalid(pointer_step("/layers", layer.id), "at most " + std::to_string(most_clip_planes) +
                                                                 " clip planes can cut at a time; hide or remove one");
}

// Refuses documents saved before `legend` became a member of `annotations`.
void refuse_old_legend(const json& document) {
    if (document.is_object() && document.contains("legend"))
        throw Invalid("/legend",
                      "/legend is not known here; it is annotations.legend: {\"annotations\": {\"legend\": true}}");
}

} // namespace

Scene parse(const json& document) {
    static const json& schema = contract().at("components").at("schemas").at("Scene");
    refuse_old_legend(document);
    if (const auto violation = check_schema(schema, document))
        throw Invalid(violation->path,
                      (violation->path.empty() ? "the scene" : printable(violation->path)) + " " + violation->reason);

    Scene scene;
    read(document, "dataset", scene.dataset);
    read(document, "time", scene.time);
    read(document, "background", scene.background);
    if (const auto annotations = document.find("annotations"); annotations != document.end())
        scene.annotations = annotations_of(*annotations);
    if (const auto lighting = document.find("lighting"); lighting != document.end())
        scene.lighting = lighting_of(*lighting);
    if (const auto camera = document.find("camera"); camera != document.end() && !camera->is_null())
        scene.camera = camera_of(*camera);
    if (const auto layers = document.find("layers"); layers != document.end())
        for (const auto& [id, layer] : layers->items()) {
            check_name(id, "/layers", "a layer's id");
            scene.layers.push_back(layer_of(id, layer));
        }
    std::sort(scene.layers.begin(), scene.layers.end(),
              [](const Layer& a, const Layer& b) { return std::tie(a.order, a.id) < std::tie(b.order, b.id); });
    check_clip_planes(scene.layers);
    return scene;
}

} // namespace ciel::scene
