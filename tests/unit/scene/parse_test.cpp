#include "scene/rules.hpp"
#include "scene/schema.hpp"

#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::scene {
namespace {

using nlohmann::json;

json fallback(const char* schema, const char* name) {
    return contract()["components"]["schemas"][schema]["properties"][name]["default"];
}

// Adds members of `schema` that have a default and are missing in `value`, recursively.
json with_defaults(json value, json schema) {
    while (schema.contains("$ref"))
        schema = contract()[json::json_pointer(schema["$ref"].get<std::string>().substr(1))];
    for (const json& form : schema.value("oneOf", json::array())) {
        const json& structure = contract()[json::json_pointer(form["$ref"].get<std::string>().substr(1))];
        if (structure["properties"]["type"]["const"] == value["type"])
            return with_defaults(std::move(value), structure);
    }
    if (schema.contains("anyOf"))
        return value.is_object() ? with_defaults(std::move(value), schema["anyOf"][0]) : value;
    if (!value.is_object()) return value;
    if (const auto each = schema.value("additionalProperties", json()); each.is_object())
        for (json& member : value) member = with_defaults(member, each);
    const json properties = schema.value("properties", json::object());
    for (const auto& [name, part] : properties.items()) {
        if (!value.contains(name) && part.contains("default")) value[name] = part["default"];
        if (value.contains(name)) value[name] = with_defaults(value[name], part);
    }
    return value;
}

TEST(scene, an_absent_member_is_the_same_as_its_default) {
    const json scene =
        json::parse(R"({"dataset": "d", "camera": {"position": [1, 2, 3], "target": [0, 0, 0]}, "layers": {
        "a": {"type": "iso", "array": "p", "values": [1], "edges": {}},
        "b": {"type": "slice", "axis": "x", "value": 0, "contours": {"array": "p", "coloring": {}}},
        "c": {"type": "surface", "threshold": {"array": "p", "range": [0, 1]}},
        "d": {"type": "outline"}, "e": {"type": "edges"}, "f": {"type": "points"},
        "g": {"type": "clip", "axis": "x", "value": 0, "color": {}}, "h": {"type": "volume", "array": "p"}}})");
    const json whole = with_defaults(scene, {{"$ref", "#/components/schemas/Scene"}});
    EXPECT_EQ(whole["layers"]["h"]["color"]["map"], "viridis");
    EXPECT_EQ(whole["layers"]["b"]["contours"]["coloring"]["solid"], "#cccccc");
    EXPECT_GT(whole.flatten().size(), scene.flatten().size() + 100);
    EXPECT_EQ(parse(whole), parse(scene));
}

TEST(scene, defaults_are_those_of_the_contract) {
    const Scene scene = parse({{"dataset", "d"},
                               {"camera", {{"position", {1, 2, 3}}, {"target", {0, 0, 0}}}},
                               {"layers", {{"i", {{"type", "iso"}, {"array", "p"}, {"values", json::array()}}}}}});
    EXPECT_EQ(fallback("Scene", "background"), "dark");
    EXPECT_EQ(std::get<Scene::Background>(scene.background), Scene::Background::dark);
    EXPECT_EQ(scene.annotations.legend, fallback("Annotations", "legend"));
    EXPECT_EQ(scene.annotations.triad, fallback("Annotations", "triad"));
    EXPECT_EQ(scene.annotations.axes, fallback("Annotations", "axes"));
    EXPECT_EQ(scene.annotations.time, fallback("Annotations", "time"));
    EXPECT_EQ(scene.annotations.dataset, fallback("Annotations", "dataset"));
    EXPECT_EQ(fallback("Annotations", "title"), scene.annotations.title);
    EXPECT_EQ(scene.annotations.scale, fallback("Annotations", "scale"));
    EXPECT_EQ(scene.lighting.on, fallback("Lighting", "on"));
    EXPECT_EQ(scene.lighting.ambient, fallback("Lighting", "ambient"));
    for (const Light& light : {scene.lighting.headlight, scene.lighting.key_light}) {
        EXPECT_EQ(light.on, fallback("Light", "on"));
        EXPECT_EQ(light.strength, fallback("Light", "strength"));
    }
    EXPECT_EQ(scene.lighting.ambient_occlusion.on, fallback("AmbientOcclusion", "on"));
    EXPECT_EQ(scene.lighting.ambient_occlusion.radius, fallback("AmbientOcclusion", "radius"));
    EXPECT_EQ(scene.lighting.ambient_occlusion.strength, fallback("AmbientOcclusion", "strength"));
    EXPECT_EQ(scene.camera->fov, fallback("Camera", "fov"));
    EXPECT_EQ(scene.camera->parallel, fallback("Camera", "parallel"));
    const Layer& layer = scene.layers.at(0);
    EXPECT_EQ(layer.visible, fallback("IsoLayer", "visible"));
    EXPECT_EQ(layer.opacity, fallback("IsoLayer", "opacity"));
    const auto& iso = std::get<IsoLayer>(layer.kind);
    EXPECT_EQ(iso.smooth, fallback("IsoLayer", "smooth"));
    EXPECT_EQ(fallback("Coloring", "map"), iso.color.map);
    EXPECT_EQ(fallback("Coloring", "solid"), "#cccccc");
    EXPECT_EQ(iso.color.solid, (Color{0xcc, 0xcc, 0xcc}));
    EXPECT_FALSE(iso.color.range);
    EXPECT_FALSE(iso.edges) << "absent: none";
    EXPECT_EQ(iso.color.reverse, fallback("Coloring", "reverse"));
    EXPECT_EQ(iso.color.log, fallback("Coloring", "log"));
    EXPECT_EQ(iso.color.symmetric, fallback("Coloring", "symmetric"));
    EXPECT_EQ(fallback("Coloring", "nan"), "#808080");
    EXPECT_EQ(iso.color.nan, (Color{0x80, 0x80, 0x80}));
    EXPECT_FALSE(iso.color.steps || iso.color.points);
    EXPECT_FALSE(iso.color.below || iso.color.above);
}

TEST(scene, a_line_s_defaults_are_those_of_the_contract) {
    const auto edges_of = [](const char* edges) {
        const Scene scene =
            parse({{"dataset", "d"}, {"layers", {{"s", {{"type", "surface"}, {"edges", json::parse(edges)}}}}}});
        return std::get<SurfaceLayer>(scene.layers.at(0).kind).edges;
    };
    const json& fallback = contract()["components"]["schemas"]["Edges"]["properties"];
    EXPECT_EQ(edges_of("{}")->width, fallback["width"]["default"]);
    EXPECT_EQ(fallback["color"]["default"], "#1a1a1a");
    EXPECT_EQ(edges_of("{}")->color, (Color{0x1a, 0x1a, 0x1a}));
    EXPECT_EQ(edges_of(R"({"color": "#ff0000", "width": 2.5})")->color, (Color{255, 0, 0}));
    EXPECT_EQ(edges_of(R"({"color": "#ff0000", "width": 2.5})")->width, 2.5);
    EXPECT_FALSE(edges_of(R"({"visible": false})"));
}

TEST(scene, every_member_of_a_coloring_is_read) {
    const Scene scene = parse(json::parse(R"({"dataset": "d", "layers": {
        "a": {"type": "surface", "color": {"array": "p", "log": true, "reverse": true, "steps": 9, "nan": "#010203",
              "below": "#aabbcc", "above": "#FFEEDD", "points": [{"at": 0.25, "color": "#000102"}, {"at": 0.25, "color": "#ffffff"}]}},
        "b": {"type": "surface", "color": {"symmetric": true, "steps": null, "below": null, "above": null, "points": null, "range": [-1, 2]}}}})"));
    const Coloring& a = std::get<SurfaceLayer>(scene.layers.at(0).kind).color;
    EXPECT_TRUE(a.log && a.reverse && !a.symmetric);
    EXPECT_EQ(a.steps, 9U);
    EXPECT_EQ(a.nan, (Color{1, 2, 3}));
    EXPECT_EQ(a.below, (Color{0xaa, 0xbb, 0xcc}));
    EXPECT_EQ(a.above, (Color{0xff, 0xee, 0xdd}));
    ASSERT_EQ(a.points->size(), 2U);
    EXPECT_EQ(a.points->at(1).at, 0.25);
    EXPECT_EQ(a.points->at(0).color, (Color{0, 1, 2}));
    const Coloring& b = std::get<SurfaceLayer>(scene.layers.at(1).kind).color;
    EXPECT_TRUE(b.symmetric && !b.log && !b.points && !b.below && !b.steps);
}

TEST(scene, every_member_is_read) {
    const Scene scene = parse(json::parse(R"({
        "dataset": "d", "time": 2.5, "background": "#102030",
        "annotations": {"legend": false, "triad": false, "axes": true, "time": true, "dataset": true, "title": "µ", "scale": 2},
        "lighting": {"on": false, "ambient": 0.5, "headlight": {"on": false, "strength": 2}, "key_light": {"strength": 3},
                     "ambient_occlusion": {"on": true, "radius": 0.25, "strength": 1.5}},
        "camera": {"position": [1, 2, 3], "target": [4, 5, 6], "up": [0, 1, 0], "fov": 45, "parallel": true, "parallel_height": 7},
        "layers": {
            "i": {"type": "iso", "order": 4, "visible": false, "opacity": 0.5, "array": "U:x", "values": [1, 2], "smooth": false,
                  "color": {"array": "p", "map": "gray", "range": [3, 4], "solid": "#ff0080"}},
            "z": {"type": "slice", "order": 3, "axis": "z", "value": -2},
            "n": {"type": "slice", "order": 2, "origin": [1, 1, 1], "normal": [0, 3, 4]},
            "b": {"type": "surface", "order": 1, "groups": ["wall", "inlet"]},
            "o": {"type": "outline", "order": 1, "color": {"solid": "#000000"}}}})"));
    EXPECT_EQ(scene.time, 2.5);
    EXPECT_EQ(std::get<Color>(scene.background), (Color{0x10, 0x20, 0x30}));
    EXPECT_FALSE(scene.annotations.legend);
    EXPECT_FALSE(scene.annotations.triad);
    EXPECT_TRUE(scene.annotations.axes);
    EXPECT_TRUE(scene.annotations.time);
    EXPECT_TRUE(scene.annotations.dataset);
    EXPECT_EQ(scene.annotations.title, "µ");
    EXPECT_EQ(scene.annotations.scale, 2);
    EXPECT_FALSE(scene.lighting.on);
    EXPECT_EQ(scene.lighting.ambient, 0.5F);
    EXPECT_FALSE(scene.lighting.headlight.on);
    EXPECT_EQ(scene.lighting.headlight.strength, 2);
    EXPECT_TRUE(scene.lighting.key_light.on);
    EXPECT_EQ(scene.lighting.key_light.strength, 3);
    EXPECT_TRUE(scene.lighting.ambient_occlusion.on);
    EXPECT_EQ(scene.lighting.ambient_occlusion.radius, 0.25);
    EXPECT_EQ(scene.lighting.ambient_occlusion.strength, 1.5F);
    EXPECT_EQ(scene.camera->target, (std::array<double, 3>{4, 5, 6}));
    EXPECT_EQ(scene.camera->up, (std::array<double, 3>{0, 1, 0}));
    EXPECT_EQ(scene.camera->parallel_height, 7);

    ASSERT_EQ(scene.layers.size(), 5U);
    std::string order;
    for (const Layer& layer : scene.layers) order += layer.id;
    EXPECT_EQ(order, "bonzi"); // sorted by order, then id
    EXPECT_EQ(std::get<SurfaceLayer>(scene.layers[0].kind).groups, (std::vector<std::string>{"wall", "inlet"}));
    EXPECT_EQ(std::get<OutlineLayer>(scene.layers[1].kind).color.solid[0], 0);
    EXPECT_EQ(plane_of(std::get<SliceLayer>(scene.layers[2].kind)).normal, (std::array<double, 3>{0, 0.6, 0.8}));
    const Plane z = plane_of(std::get<SliceLayer>(scene.layers[3].kind));
    EXPECT_EQ(z.normal, (std::array<double, 3>{0, 0, 1}));
    EXPECT_EQ(z.origin, (std::array<double, 3>{0, 0, -2}));
    const auto& iso = std::get<IsoLayer>(scene.layers[4].kind);
    EXPECT_FALSE(scene.layers[4].visible);
    EXPECT_EQ(scene.layers[4].opacity, 0.5F);
    EXPECT_EQ(iso.values, (std::vector<double>{1, 2}));
    EXPECT_FALSE(iso.smooth);
    EXPECT_EQ(iso.color.range, (std::array<double, 2>{3, 4}));
    EXPECT_EQ(iso.color.solid, (Color{255, 0, 128}));
}

TEST(scene, six_clip_planes_may_be_visible_and_no_more) {
    json document{{"dataset", "d"}, {"layers", json::object()}};
    for (const char* id : {"a", "b", "c", "d", "e", "f", "g"})
        document["layers"][id] = {{"type", "clip"}, {"axis", "y"}, {"value", 1}};
    try {
        (void)parse(document);
        ADD_FAILURE() << "seven were taken";
    } catch (const Invalid& error) {
        EXPECT_EQ(error.path, "/layers/g");
        EXPECT_STREQ(error.what(), "at most 6 clip planes can be visible at a time; hide or remove a clip layer");
    }
    document["layers"]["b"]["visible"] = false;
    EXPECT_EQ(parse(document).layers.size(), 7U);
}

TEST(scene, clips_edges_points_and_thresholds_are_read) {
    const Scene scene = parse(json::parse(R"({"dataset": "d", "layers": {
        "c": {"type": "clip", "order": 1, "axis": "z", "value": 2, "invert": true, "caps": false},
        "e": {"type": "edges", "order": 2, "angle": 30, "width": 2, "groups": ["wall"],
              "threshold": {"array": "p", "range": [1, 2], "keep": "any"}},
        "p": {"type": "points", "order": 3, "of": "all", "size": 9, "most": 5},
        "s": {"type": "surface", "order": 4, "threshold": {"array": "p", "range": [1, 2], "enabled": false}},
        "t": {"type": "edges", "order": 5}, "u": {"type": "points", "order": 6}}})"));
    const auto& clip = std::get<ClipLayer>(scene.layers[0].kind);
    EXPECT_EQ(plane_of(clip).normal, (std::array<double, 3>{0, 0, -1}));
    EXPECT_EQ(plane_of(clip).origin[2], 2);
    EXPECT_FALSE(clip.caps);
    const auto& edges = std::get<EdgesLayer>(scene.layers[1].kind);
    EXPECT_EQ(edges.angle, 30);
    EXPECT_EQ(edges.width, 2);
    EXPECT_EQ(edges.groups.size(), 1U);
    EXPECT_EQ(edges.threshold->keep, Threshold::Keep::any);
    EXPECT_EQ(edges.threshold->range, (std::array<double, 2>{1, 2}));
    const auto& points = std::get<PointsLayer>(scene.layers[2].kind);
    EXPECT_EQ(points.of, PointsLayer::Of::all);
    EXPECT_EQ(points.size, 9);
    EXPECT_EQ(points.most, 5U);
    EXPECT_FALSE(std::get<SurfaceLayer>(scene.layers[3].kind).threshold);
    const json& schemas = contract()["components"]["schemas"];
    const auto fallback = [&](const char* schema, const char* name) {
        return schemas[schema]["properties"][name]["default"];
    };
    EXPECT_EQ(std::get<EdgesLayer>(scene.layers[4].kind).width, fallback("EdgesLayer", "width"));
    EXPECT_FALSE(std::get<EdgesLayer>(scene.layers[4].kind).angle);
    EXPECT_EQ(std::get<PointsLayer>(scene.layers[5].kind).size, fallback("PointsLayer", "size"));
    EXPECT_EQ(std::get<PointsLayer>(scene.layers[5].kind).most, fallback("PointsLayer", "most"));
    EXPECT_EQ(fallback("PointsLayer", "of"), "boundary");
    EXPECT_EQ(fallback("Threshold", "keep"), "all");
    EXPECT_EQ(fallback("ClipLayer", "caps"), true);
}

struct Malformed {
    const char *name, *json, *path, *message;
};
constexpr Malformed table[] = {
    {"not_an_object", R"([])", "", "the scene must be an object"},
    {"no_dataset", R"({})", "/dataset", "/dataset is missing"},
    {"empty_dataset", R"({"dataset": ""})", "/dataset", "/dataset must have at least 1 character"},
    {"unknown_member", R"({"dataset": "d", "color": 1})", "/color",
     "/color is not a known member; the known members are annotations, background, camera, dataset, layers, lighting, "
     "time"},
    {"legend_of_older_documents", R"({"dataset": "d", "legend": true})", "/legend",
     "/legend is not a member of a scene; use annotations.legend: {\"annotations\": {\"legend\": true}}"},
    {"time_is_text", R"({"dataset": "d", "time": "1"})", "/time", "/time must be a number"},
    {"background", R"({"dataset": "d", "background": "pink"})", "/background",
     "/background must be one of \"dark\", \"light\", or must be a color of the form #rrggbb"},
    {"legend", R"({"dataset": "d", "annotations": {"legend": 1}})", "/annotations/legend",
     "/annotations/legend must be true or false"},
    {"unknown_annotation", R"({"dataset": "d", "annotations": {"legends": true}})", "/annotations/legends",
     "/annotations/legends is not a known member; the known members are axes, dataset, legend, scale, time, title, "
     "triad"},
    {"annotation_scale", R"({"dataset": "d", "annotations": {"scale": 0.1}})", "/annotations/scale",
     "/annotations/scale must be at least 0.25"},
    {"camera_without_target", R"({"dataset": "d", "camera": {"position": [0, 0, 1]}})", "/camera/target",
     "/camera/target is missing"},
    {"camera_of_two_numbers", R"({"dataset": "d", "camera": {"position": [0, 0], "target": [0, 0, 0]}})",
     "/camera/position", "/camera/position must have at least 3 items"},
    {"camera_in_its_target", R"({"dataset": "d", "camera": {"position": [0, 0, 0], "target": [0, 0, 0]}})",
     "/camera/position", "the camera's position and target must differ"},
    {"camera_without_up",
     R"({"dataset": "d", "camera": {"position": [0, 0, 1], "target": [0, 0, 0], "up": [0, 0, 0]}})", "/camera/up",
     "the camera's up direction must not be zero"},
    {"camera_fov", R"({"dataset": "d", "camera": {"position": [0, 0, 1], "target": [0, 0, 0], "fov": 180}})",
     "/camera/fov", "/camera/fov must be less than 180"},
    {"parallel_without_height",
     R"({"dataset": "d", "camera": {"position": [0, 0, 1], "target": [0, 0, 0], "parallel": true}})",
     "/camera/parallel_height", "a parallel camera needs parallel_height, the height of the view"},
    {"layers_are_a_list", R"({"dataset": "d", "layers": []})", "/layers", "/layers must be an object"},
    {"layer_is_a_number", R"({"dataset": "d", "layers": {"a": 3}})", "/layers/a", "/layers/a must be an object"},
    {"layer_without_type", R"({"dataset": "d", "layers": {"a": {}}})", "/layers/a/type",
     "/layers/a/type must be one of \"iso\", \"slice\", \"surface\", \"outline\", \"clip\", \"edges\", \"points\", "
     "\"volume\""},
    {"layer_of_unknown_type", R"({"dataset": "d", "layers": {"a": {"type": "fog"}}})", "/layers/a/type",
     "/layers/a/type must be one of \"iso\", \"slice\", \"surface\", \"outline\", \"clip\", \"edges\", \"points\", "
     "\"volume\""},
    {"iso_without_values", R"({"dataset": "d", "layers": {"a": {"type": "iso", "array": "p"}}})", "/layers/a/values",
     "/layers/a/values is missing"},
    {"iso_value_is_text", R"({"dataset": "d", "layers": {"a": {"type": "iso", "array": "p", "values": [1, "2"]}}})",
     "/layers/a/values/1", "/layers/a/values/1 must be a number"},
    {"opacity", R"({"dataset": "d", "layers": {"a": {"type": "outline", "opacity": 1.5}}})", "/layers/a/opacity",
     "/layers/a/opacity must be at most 1"},
    {"id_is_escaped", R"({"dataset": "d", "layers": {"a/b~c": {"type": "outline", "opacity": -1}}})",
     "/layers/a~1b~0c/opacity", "/layers/a~1b~0c/opacity must be at least 0"},
    {"member_of_another_kind", R"({"dataset": "d", "layers": {"a": {"type": "outline", "values": []}}})",
     "/layers/a/values",
     "/layers/a/values is not a known member; the known members are color, opacity, order, type, visible"},
    {"edges_is_a_flag", R"({"dataset": "d", "layers": {"a": {"type": "surface", "edges": true}}})", "/layers/a/edges",
     "/layers/a/edges must be an object"},
    {"edges_without_width", R"({"dataset": "d", "layers": {"a": {"type": "surface", "edges": {"width": 0}}}})",
     "/layers/a/edges/width", "/layers/a/edges/width must be more than 0"},
    {"edges_of_an_outline", R"({"dataset": "d", "layers": {"a": {"type": "outline", "edges": {}}}})", "/layers/a/edges",
     "/layers/a/edges is not a known member; the known members are color, opacity, order, type, visible"},
    {"contours_of_nothing",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "x", "value": 0, "contours": {}}}})",
     "/layers/a/contours/array", "/layers/a/contours/array is missing"},
    {"contours_twice",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "x", "value": 0, "contours": {"array": "p", "values": [1], "count": 3}}}})",
     "/layers/a/contours", "contours must have either values, or count and range, but not both"},
    {"contours_backwards",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "x", "value": 0, "contours": {"array": "p", "range": [1, 0]}}}})",
     "/layers/a/contours/range", "a range must be [minimum, maximum] with minimum <= maximum"},
    {"clip_of_nothing", R"({"dataset": "d", "layers": {"a": {"type": "clip"}}})", "/layers/a",
     "a clip must have either axis and value, or origin and normal"},
    {"clip_without_direction",
     R"({"dataset": "d", "layers": {"a": {"type": "clip", "origin": [0, 0, 0], "normal": [0, 0, 0]}}})",
     "/layers/a/normal", "a clip's normal must not be zero"},
    {"clip_with_opacity",
     R"({"dataset": "d", "layers": {"a": {"type": "clip", "axis": "x", "value": 0, "opacity": 1}}})",
     "/layers/a/opacity",
     "/layers/a/opacity is not a known member; the known members are axis, caps, color, invert, normal, order, origin, "
     "type, value, visible"},
    {"threshold_of_nothing", R"({"dataset": "d", "layers": {"a": {"type": "surface", "threshold": {"array": "p"}}}})",
     "/layers/a/threshold/range", "/layers/a/threshold/range is missing"},
    {"threshold_backwards",
     R"({"dataset": "d", "layers": {"a": {"type": "edges", "threshold": {"array": "p", "range": [2, 1]}}}})",
     "/layers/a/threshold/range", "a range must be [minimum, maximum] with minimum <= maximum"},
    {"threshold_of_an_iso_surface",
     R"({"dataset": "d", "layers": {"a": {"type": "iso", "array": "p", "values": [], "threshold": {"array": "p", "range": [2, 1]}}}})",
     "/layers/a/threshold",
     "/layers/a/threshold is not a known member; the known members are array, color, edges, opacity, order, smooth, "
     "type, values, visible"},
    {"points_of_patches_and_all",
     R"({"dataset": "d", "layers": {"a": {"type": "points", "of": "all", "groups": ["wall"]}}})", "/layers/a/groups",
     "groups chooses points of the boundary only; leave out groups or \"of\": \"all\""},
    {"no_points", R"({"dataset": "d", "layers": {"a": {"type": "points", "most": 0}}})", "/layers/a/most",
     "/layers/a/most must be at least 1"},
    {"edges_of_a_wide_angle", R"({"dataset": "d", "layers": {"a": {"type": "edges", "angle": 181}}})",
     "/layers/a/angle", "/layers/a/angle must be at most 180"},
    {"slice_of_nothing", R"({"dataset": "d", "layers": {"a": {"type": "slice"}}})", "/layers/a",
     "a slice must have either axis and value, or origin and normal"},
    {"slice_of_both",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "x", "value": 0, "normal": [1, 0, 0]}}})",
     "/layers/a", "a slice must have either axis and value, or origin and normal"},
    {"slice_of_half", R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "x"}}})", "/layers/a",
     "a slice must have either axis and value, or origin and normal"},
    {"slice_axis", R"({"dataset": "d", "layers": {"a": {"type": "slice", "axis": "w", "value": 0}}})", "/layers/a/axis",
     "/layers/a/axis must be one of \"x\", \"y\", \"z\""},
    {"slice_without_direction",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "origin": [0, 0, 0], "normal": [0, 0, 0]}}})",
     "/layers/a/normal", "a slice's normal must not be zero"},
    {"slice_normal_overflows",
     R"({"dataset": "d", "layers": {"a": {"type": "slice", "origin": [0, 0, 0], "normal": [1.7e308, 1.7e308, 0]}}})",
     "/layers/a/normal", "a slice's normal must not be zero"},
    {"volume_without_array", R"({"dataset": "d", "layers": {"a": {"type": "volume"}}})", "/layers/a/array",
     "/layers/a/array is missing"},
    {"volume_points_out_of_order",
     R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "opacity_points": [[0.5, 0], [0.4, 1]]}}})",
     "/layers/a/opacity_points/1", "opacity points must be in ascending order of their positions"},
    {"volume_opacity_beyond_one",
     R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "opacity_points": [[0, 1.5]]}}})",
     "/layers/a/opacity_points/0/1", "/layers/a/opacity_points/0/1 must be at most 1"},
    {"volume_without_points",
     R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "opacity_points": []}}})",
     "/layers/a/opacity_points", "/layers/a/opacity_points must have at least 1 item"},
    {"volume_of_too_many_slices",
     R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "slices": 1001}}})", "/layers/a/slices",
     "/layers/a/slices must be at most 1000, or must be null"},
    {"volume_of_no_length", R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "unit_length": 0}}})",
     "/layers/a/unit_length", "/layers/a/unit_length must be more than 0, or must be null"},
    {"volume_direction", R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "direction": "w"}}})",
     "/layers/a/direction", "/layers/a/direction must be one of \"auto\", \"x\", \"y\", \"z\", \"screen\""},
    {"volume_of_two_arrays",
     R"({"dataset": "d", "layers": {"a": {"type": "volume", "array": "p", "color": {"array": "q"}}}})",
     "/layers/a/color/array", "a volume must have the colors of its own array, p"},
    {"lighting_too_strong", R"({"dataset": "d", "lighting": {"headlight": {"strength": 5}}})",
     "/lighting/headlight/strength", "/lighting/headlight/strength must be at most 4"},
    {"lighting_below_zero", R"({"dataset": "d", "lighting": {"ambient": -1}})", "/lighting/ambient",
     "/lighting/ambient must be at least 0"},
    {"lighting_unknown_light", R"({"dataset": "d", "lighting": {"fill_light": {}}})", "/lighting/fill_light",
     "/lighting/fill_light is not a known member; the known members are ambient, ambient_occlusion, headlight, "
     "key_light, on"},
    {"occlusion_without_radius", R"({"dataset": "d", "lighting": {"ambient_occlusion": {"radius": 0}}})",
     "/lighting/ambient_occlusion/radius", "/lighting/ambient_occlusion/radius must be more than 0"},
    {"occlusion_wider_than_all", R"({"dataset": "d", "lighting": {"ambient_occlusion": {"radius": 1.5}}})",
     "/lighting/ambient_occlusion/radius", "/lighting/ambient_occlusion/radius must be at most 1"},
    {"color_range", R"({"dataset": "d", "layers": {"a": {"type": "outline", "color": {"range": [2, 1]}}}})",
     "/layers/a/color/range", "a range must be [minimum, maximum] with minimum <= maximum"},
    {"color_range_of_text", R"({"dataset": "d", "layers": {"a": {"type": "outline", "color": {"range": "all"}}}})",
     "/layers/a/color/range", "/layers/a/color/range must be an array, or must be null"},
    {"color_solid", R"({"dataset": "d", "layers": {"a": {"type": "outline", "color": {"solid": "#12345"}}}})",
     "/layers/a/color/solid", "/layers/a/color/solid must be a color of the form #rrggbb"},
    {"color_log_of_zero",
     R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"log": true, "range": [0, 1]}}}})",
     "/layers/a/color/range",
     "a logarithmic scale cannot show zero or negative values; give a range that begins above zero, add symmetric, or "
     "leave out log"},
    {"color_one_step", R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"steps": 1}}}})",
     "/layers/a/color/steps", "/layers/a/color/steps must be at least 2, or must be null"},
    {"color_nan", R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"nan": "red"}}}})",
     "/layers/a/color/nan", "/layers/a/color/nan must be a color of the form #rrggbb"},
    {"color_one_point",
     R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"points": [{"at": 0, "color": "#000000"}]}}}})",
     "/layers/a/color/points", "/layers/a/color/points must have at least 2 items, or must be null"},
    {"color_point_outside",
     R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"points": [{"at": 0, "color": "#000000"}, {"at": 1.5, "color": "#000000"}]}}}})",
     "/layers/a/color/points/1/at", "/layers/a/color/points/1/at must be at most 1"},
    {"color_points_out_of_order",
     R"({"dataset": "d", "layers": {"a": {"type": "surface", "color": {"points": [{"at": 0.5, "color": "#000000"}, {"at": 0.4, "color": "#000000"}]}}}})",
     "/layers/a/color/points/1/at", "the points of a color map must be in ascending order of at"},
    {"group_is_a_number", R"({"dataset": "d", "layers": {"a": {"type": "surface", "groups": [7]}}})",
     "/layers/a/groups/0", "/layers/a/groups/0 must be a string"},
};

TEST(scene, a_volume_has_the_defaults_of_the_contract) {
    const auto layer =
        parse(json::parse(R"({"dataset": "d", "layers": {"v": {"type": "volume", "array": "p"}}})")).layers.at(0);
    const auto& volume = std::get<VolumeLayer>(layer.kind);
    EXPECT_EQ(volume.opacity_points,
              (fallback("VolumeLayer", "opacity_points").get<std::vector<std::array<double, 2>>>()));
    EXPECT_FALSE(volume.slices);
    EXPECT_EQ(volume.shaded, fallback("VolumeLayer", "shaded"));
    EXPECT_EQ(fallback("VolumeLayer", "direction"), "auto");
    EXPECT_EQ(volume.direction, VolumeLayer::Direction::automatic);
    EXPECT_FALSE(volume.unit_length);
}

TEST(scene, malformed_documents_are_refused_with_their_path) {
    for (const Malformed& row : table) {
        try {
            (void)parse(json::parse(row.json));
            ADD_FAILURE() << row.name << " was accepted";
        } catch (const Invalid& error) {
            EXPECT_EQ(error.path, row.path) << row.name;
            EXPECT_STREQ(error.what(), row.message) << row.name;
        }
    }
}

TEST(scene, more_layers_and_values_than_the_contract_allows) {
    json scene{{"dataset", "d"}};
    for (int i = 0; i < 65; ++i) scene["layers"][std::to_string(i)] = {{"type", "outline"}};
    EXPECT_THROW((void)parse(scene), Invalid);
    scene["layers"].erase("0");
    EXPECT_EQ(parse(scene).layers.size(), 64U);
}

} // namespace
} // namespace server::scene
