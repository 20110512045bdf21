// Queries about a scene: probes, picks, bounds, ranges, exports.
#include "methods.hpp"

#include <cmath>
#include <cstring>
#include <gmock/gmock.h>
#include <set>

namespace ciel::test {
namespace {

TEST_F(Methods, probe_by_position_and_by_pixel) {
    json params{{"scene", colored_scene}, {"position", {1001, 1, -49}}};
    const json here = client.call("probe.point", params);
    EXPECT_EQ(here["hit"], true);
    EXPECT_NEAR(here["values"]["p"], 6, 1e-4);
    params["position"] = {0, 0, 0};
    EXPECT_EQ(client.call("probe.point", params)["hit"], false);

    // The camera looks along x through the box's center at the plane x = 1001.
    params.erase("position");
    params["scene"] = json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47]},
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001}}})");
    params.update({{"width", 101}, {"height", 101}, {"pixel", {50, 50}}});
    const json hit = client.call("probe.point", params);
    ASSERT_EQ(hit["hit"], true);
    const Vec3d at = hit["position"];
    EXPECT_NEAR(at[0], 1001, 0.01);
    EXPECT_NEAR(at[1], 3, 0.1);
    EXPECT_NEAR(hit["values"]["p"].get<double>(), pressure({at[0] - 1000, at[1], at[2] + 50}, 0), 1e-3);
    params["pixel"] = {0, 0};
    const json background = client.call("probe.point", params);
    EXPECT_EQ(background["hit"], false);
    EXPECT_EQ(background["position"], nullptr);
}

TEST_F(Methods, probes_and_picks_name_the_layer_and_the_patch) {
    json params{{"pixel", {50, 50}}, {"width", 101}, {"height", 101}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3.1, -47.3], "target": [1003, 3.1, -47.3]},
        "layers": {"walls": {"type": "surface"}}})")}};
    const json probed = client.call("probe.point", params);
    EXPECT_EQ(probed["layer"], "walls");
    EXPECT_EQ(probed["patch"], "left");
    const json picked = client.call("scene.pick", params);
    EXPECT_EQ(picked["layer"], "walls");
    EXPECT_EQ(picked["patch"], "left");
    EXPECT_NEAR(picked["position"][0].get<double>(), 1000, 1e-3);
    params["scene"]["layers"]["walls"]["groups"] = {"body"};
    EXPECT_EQ(client.call("probe.point", params)["patch"], "body");
    params["pixel"] = {0, 0};
    const json background = client.call("scene.pick", params);
    EXPECT_EQ(background["position"], nullptr);
    EXPECT_EQ(background["layer"], nullptr);
    EXPECT_EQ(background["center"], json({1003, 3, -47})) << "of the body, though the pixel is beside it";
    EXPECT_EQ(client.call("probe.point", params)["patch"], nullptr);
    params.erase("pixel");
    params["position"] = {1001, 1, -49};
    EXPECT_EQ(client.call("probe.point", params)["layer"], nullptr) << "a position is on no layer";
}

TEST_F(Methods, bounds_of_the_mesh_and_of_what_is_drawn) {
    json params{{"scene", {{"dataset", "box"}, {"layers", {{"b", {{"type", "surface"}, {"groups", {"body"}}}}}}}}};
    EXPECT_EQ(client.call("scene.bounds", params)["bounds"], json({1000, 1006, 0, 6, -50, -44}));
    params["of"] = "drawn";
    EXPECT_EQ(client.call("scene.bounds", params)["bounds"], json({1002, 1004, 2, 4, -48, -46}));
}

TEST_F(Methods, color_range_is_that_of_the_values_in_view) {
    json params{{"layers", {"s"}}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47], "parallel": true, "parallel_height": 100},
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001, "color": {"array": "U:x"}},
                   "plain": {"type": "slice", "axis": "x", "value": 1002}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6})); // U:x is the height above the box's floor
    params["aspect"] = 1;
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    json& camera = params["scene"]["camera"];
    camera["parallel_height"] = 2.5; // shows heights from 1.75 to 4.25
    const json part = client.call("color.range", params)["range"];
    EXPECT_GE(part[0], 1.75);
    EXPECT_LE(part[0], 3);
    EXPECT_GE(part[1], 3);
    EXPECT_LE(part[1], 4.25);
    camera["target"] = {1003, 3, 1000};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "nothing is in view";
    params.erase("aspect");
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["layers"] = {"plain"};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "a layer without an array has no values";
    params["layers"] = {"s", "none"};
    EXPECT_EQ(client.error_code("color.range", params), -32001);
}

TEST_F(Methods, a_clip_plane_far_beyond_the_mesh_takes_all_away_or_nothing) {
    json params{{"width", 60}, {"height", 40}, {"scene", json::parse(R"({"dataset": "box",
        "layers": {"s": {"type": "surface"}}})")}};
    const json whole = client.call("picture.render", params)["data"];
    json& clip = params["scene"]["layers"]["c"];
    clip = {{"type", "clip"}, {"origin", {1e300, 3, 0}}, {"normal", {1, 1, 0}}};
    EXPECT_EQ(client.call("picture.render", params)["data"], whole);
    clip["invert"] = true;
    const json nothing = client.call("picture.render", params)["data"];
    EXPECT_NE(nothing, whole);
    params["scene"]["layers"] = json::object();
    EXPECT_EQ(client.call("picture.render", params)["data"], nothing);
}

TEST_F(Methods, a_scene_without_a_camera_is_seen_from_where_its_pictures_are) {
    json params{{"width", 300}, {"height", 200}, {"scene", json::parse(R"({"dataset": "box",
        "annotations": {"axes": true, "title": "A title"},
        "layers": {"s": {"type": "surface", "color": {"array": "p"}}}})")}};
    const json camera = client.call("scene.camera", params);
    const json picture = client.call("picture.render", params);
    json given = params;
    given["scene"]["camera"] = camera;
    EXPECT_EQ(client.call("picture.render", given)["data"], picture["data"]);
    EXPECT_EQ(client.call("scene.camera", given), camera);
    params["scene"]["annotations"]["axes"] = false;
    EXPECT_NE(client.call("scene.camera", params), camera) << "it leaves room for what is written";
    given["scene"]["camera"] = {{"position", {0, 0, 9}}, {"target", {0, 0, 0}}, {"up", {0, 1, 0}}, {"fov", 20},
                                {"parallel", true},      {"parallel_height", 3}};
    EXPECT_EQ(client.call("scene.camera", given), given["scene"]["camera"]);
}

// U:x ranges from 0 to 6 and p over other values, so a common range would fit neither.
TEST_F(Methods, color_range_of_contour_lines_is_apart_from_that_of_the_slice_below_them) {
    json params{{"layers", {"s"}}, {"scene", json::parse(R"({"dataset": "box",
        "layers": {"s": {"type": "slice", "axis": "x", "value": 1001, "color": {"array": "U:x"},
                         "contours": {"array": "p", "values": [11, 14, 1e6], "coloring": {}}}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["of"] = "contours";
    EXPECT_EQ(client.call("color.range", params)["range"], json({11, 14})) << "of the lines that there are";
    params["scene"]["layers"]["s"]["contours"].erase("coloring");
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "lines of one color are on no scale";
    params["of"] = "edges";
    EXPECT_EQ(client.error_code("color.range", params), -32602);
}

// U:x is the height above the box's floor at z = -50.
TEST_F(Methods, color_range_of_a_volume_is_that_of_what_is_in_view_and_not_cut_away) {
    json params{{"layers", {"v"}}, {"scene", json::parse(R"({"dataset": "box",
        "camera": {"position": [980, 3, -47], "target": [1003, 3, -47], "parallel": true, "parallel_height": 100},
        "layers": {"v": {"type": "volume", "array": "U:x", "slices": 60}}})")}};
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    params["aspect"] = 1;
    EXPECT_EQ(client.call("color.range", params)["range"], json({0, 6}));
    json& camera = params["scene"]["camera"];
    camera["parallel_height"] = 2.5; // shows heights from 1.75 to 4.25
    const json part = client.call("color.range", params)["range"];
    ASSERT_TRUE(part.is_array());
    EXPECT_GE(part[0], 1.75);
    EXPECT_LE(part[0], 2);
    EXPECT_GE(part[1], 4);
    EXPECT_LE(part[1], 4.25);
    camera["parallel_height"] = 100;
    params["scene"]["layers"]["c"] = {{"type", "clip"}, {"axis", "z"}, {"value", -47.5}};
    const json cut = client.call("color.range", params)["range"];
    EXPECT_EQ(cut[0], 0);
    EXPECT_GE(cut[1], 2);
    EXPECT_LE(cut[1], 2.5);
    camera["parallel_height"] = 2.5;
    camera["target"] = {1003, 3, 1000};
    EXPECT_EQ(client.call("color.range", params)["range"], nullptr) << "nothing is in view";
}

TEST_F(Methods, surfaces_are_exported) {
    json params{{"scene", colored_scene}, {"layer", "iso"}, {"format", "ply"}};
    params["scene"]["layers"]["iso"]["values"] = {12, 20};
    const json ply = client.call("surface.export", params);
    EXPECT_EQ(ply["name"], "iso.ply");
    EXPECT_EQ(ply["origin"], json({0, 0, 0}));
    const std::string head = decoded(ply["data"]).substr(0, 400);
    EXPECT_THAT(head, testing::HasSubstr("element vertex " + ply["vertices"].dump() + "\n"));
    EXPECT_THAT(head, testing::HasSubstr("element face " + ply["polygons"].dump() + "\n"));
    params["scene"]["layers"]["iso"]["values"] = {12};
    const json one = client.call("surface.export", params);
    params["scene"]["layers"]["iso"]["values"] = {20};
    const json other = client.call("surface.export", params);
    EXPECT_EQ(ply["polygons"], one["polygons"].get<int>() + other["polygons"].get<int>());

    params["format"] = "vtp";
    const json vtp = client.call("surface.export", params);
    EXPECT_EQ(vtp["polygons"], other["polygons"]);
    EXPECT_THAT(decoded(vtp["data"]),
                testing::AllOf(testing::HasSubstr("<Piece NumberOfPoints=\"" + other["vertices"].dump() + "\" "),
                               testing::HasSubstr(" NumberOfPolys=\"" + other["polygons"].dump() + "\">"),
                               testing::EndsWith("</VTKFile>\n")));

    params["format"] = "stl";
    const json stl = client.call("surface.export", params);
    const std::string triangles = decoded(stl["data"]);
    EXPECT_GE(stl["polygons"], other["polygons"]) << "of triangles";
    EXPECT_EQ(stl["origin"], json({1003, 3, -47})) << "the box is 1000 away and 6 long";
    EXPECT_EQ(triangles.substr(0, 32), std::string("CIEL surface, origin 1003 3 -47\0", 32));
    ASSERT_EQ(triangles.size(), 84 + 50 * stl["polygons"].get<std::size_t>());
    std::uint32_t count = 0;
    std::memcpy(&count, &triangles[80], sizeof count);
    EXPECT_EQ(count, stl["polygons"]);
    params["layer"] = "nope";
    EXPECT_EQ(client.error_code("surface.export", params), -32001);
}

// Reads the floats of an array in the appended data of a VTP file.
std::vector<float> appended_floats(const std::string& file, const std::string& name) {
    const std::size_t declared = file.find("Name=\"" + name + "\""), offset = file.find("offset=\"", declared) + 8;
    std::size_t at = file.find("_", file.find("<AppendedData")) + 1 + std::stoul(file.substr(offset));
    std::uint64_t bytes = 0;
    std::memcpy(&bytes, &file[at], sizeof bytes);
    std::vector<float> values(bytes / sizeof(float));
    std::memcpy(values.data(), &file[at + sizeof bytes], bytes);
    return values;
}

// Values of cell:q are cell ids. The slice has one polygon for each cell that it cuts.
TEST_F(Methods, values_of_cells_are_exported_as_they_are) {
    json params{{"scene", colored_scene}, {"layer", "s"}, {"format", "vtp"}};
    json& layer = params["scene"]["layers"]["s"];
    layer = {{"type", "slice"}, {"axis", "x"}, {"value", box_origin[0] + 1.5}, {"color", {{"array", "cell:q"}}}};
    const json flat = client.call("surface.export", params);
    const std::vector<float> values = appended_floats(decoded(flat["data"]), "cell:q");
    EXPECT_EQ(values.size(), flat["vertices"]);
    for (const float value : values) EXPECT_EQ(value, std::round(value)) << "nothing is mixed";
    EXPECT_EQ(std::set<float>(values.begin(), values.end()).size(), flat["polygons"]);
    layer["color"] = {{"array", "p"}};
    EXPECT_LT(client.call("surface.export", params)["vertices"], flat["vertices"]) << "there they are shared";
}

// The box of 6 x 6 x 6 with a cavity of 2 x 2 x 2, cut in the middle. The exported surface is closed and is the visible
// half.
TEST_F(Methods, exports_are_cut_as_pictures_are) {
    json params{{"scene", colored_scene}, {"layer", "s"}, {"format", "stl"}};
    json& layers = params["scene"]["layers"];
    layers = {{"s", {{"type", "surface"}}}, {"c", {{"type", "clip"}, {"axis", "x"}, {"value", box_origin[0] + 3}}}};
    const std::string bytes = decoded(client.call("surface.export", params)["data"]);
    double six = 0;
    for (std::size_t at = 84; at + 50 <= bytes.size(); at += 50) {
        std::array<std::array<float, 3>, 3> corner{};
        std::memcpy(&corner, &bytes[at + 12], sizeof corner);
        const auto rel = [&](std::size_t i, std::size_t axis) { return corner[i][axis] - box_origin[axis]; };
        six += rel(0, 0) * (rel(1, 1) * rel(2, 2) - rel(1, 2) * rel(2, 1)) +
               rel(0, 1) * (rel(1, 2) * rel(2, 0) - rel(1, 0) * rel(2, 2)) +
               rel(0, 2) * (rel(1, 0) * rel(2, 1) - rel(1, 1) * rel(2, 0));
    }
    EXPECT_NEAR(six / 6, 3 * 36 - 4, 0.05);
    for (const char* id : {"c", "e"}) {
        layers["e"] = {{"type", "edges"}};
        params["layer"] = id;
        EXPECT_EQ(client.error_code("surface.export", params), -32602) << id;
    }
}

} // namespace
} // namespace ciel::test
