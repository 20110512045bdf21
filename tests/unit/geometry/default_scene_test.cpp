#include "geometry/default_scene.hpp"

#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "store/writer.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/meshes.hpp"
#include "support/small_dataset/small_dataset.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>
#include <limits>

namespace server::geometry {
using namespace ciel;
namespace {

class default_scene_of : public testing::Test {
protected:
    [[nodiscard]] DefaultScene shown() const {
        return default_scene(*store::Catalog({folder.path()}).open("box"), "box");
    }
    [[nodiscard]] std::filesystem::path box() const { return folder.path() / "box.ciel"; }

    const test::Folder folder;
};

TEST_F(default_scene_of, a_body_is_the_body_with_pressure_and_a_slice_with_speed) {
    test::write_small_dataset(box());
    store::Catalog catalog({folder.path()});
    const auto loaded = catalog.open("box");
    const auto [document, looked_at] = default_scene(*loaded, "box");
    const scene::Scene scene = scene::parse(document);
    EXPECT_EQ(scene.dataset, "box");
    EXPECT_EQ(scene.time, 2) << "the last step";
    EXPECT_FALSE(document["layers"].contains("iso")) << "it would hide the body";
    const auto& surface = document["layers"]["surface"];
    EXPECT_EQ(surface["groups"], nlohmann::json::array({"body"})); // not the outer side "left"
    EXPECT_EQ(surface["color"]["array"], "p");
    const auto& slice = document["layers"]["slice"];
    EXPECT_EQ(slice["color"]["array"], "U:magnitude");
    EXPECT_EQ(slice["axis"], "y");
    EXPECT_NEAR(slice["value"].get<double>(), test::box_origin[1] + 3, 1e-6) << "through the middle of the body";
    for (std::size_t axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(looked_at.low[axis], test::box_origin[axis] + 2, 1e-6);
        EXPECT_NEAR(looked_at.high[axis], test::box_origin[axis] + 4, 1e-6);
    }
    ASSERT_TRUE(scene.camera);
    EXPECT_NEAR(scene.camera->target[2], test::box_origin[2] + 3, 1e-6) << "the camera is on the body";

    SceneGeometry geometry(test::chosen_algorithm());
    const auto drawn = geometry.update({scene, loaded});
    EXPECT_EQ(drawn->drawables.size(), 3U);
    EXPECT_TRUE(drawn->lacking.empty());
    EXPECT_GT(drawn->triangles, 20U);
}

TEST_F(default_scene_of, pressure_and_velocity_are_known_by_their_names) {
    test::write_small_dataset(box());
    const auto vertices = store::Dataset::open(box())->info().meshes[0].vertices;
    std::vector<float> scalar, vector;
    for (std::size_t i = 0; i < 3 * vertices; ++i) (i < vertices ? scalar : vector).push_back(static_cast<float>(i));
    vector.resize(3 * vertices, 0.5F);
    auto writer = store::Writer::append(box());
    using store::Association;
    const std::vector<store::ArrayValues> values{{{"Gradient", Association::point, 3, "", ""}, vector},
                                                 {{"Velocity", Association::point, 3, "m/s", ""}, vector},
                                                 {{"density", Association::point, 1, "", ""}, scalar},
                                                 {{"staticPressure", Association::point, 1, "Pa", ""}, scalar}};
    writer.add_step(3, 0, 0, values);
    writer.finish();
    const auto layers = shown().document["layers"];
    EXPECT_EQ(layers["surface"]["color"]["array"], "staticPressure");
    EXPECT_EQ(layers["slice"]["color"]["array"], "Velocity:magnitude");
}

TEST_F(default_scene_of, one_layer_of_cells_is_seen_from_above_as_a_slice) {
    const test::Polyhedra input = test::hexahedra({{6, 5, 1}});
    const Assembled assembled = assemble(test::view(input));
    std::vector<Index> faces;
    for (Index face = 0; face < assembled.mesh.owner.size(); ++face)
        if (assembled.mesh.neighbour[face] == none) faces.push_back(face);
    std::vector<float> p;
    for (std::size_t i = 0; i < assembled.mesh.positions.size(); i += 3) p.push_back(assembled.mesh.positions[i]);
    for (const char* type : {"empty", "wedge", "patch"}) {
        store::NamedGroup group{store::Group::Of::faces, "frontAndBack", faces};
        group.facts.type = type;
        store::Writer writer(box(), {"a generator", "m", input.vertex_count(), 0, input.cell_count(), {}}, true);
        writer.add_mesh(assembled.mesh, assembled.original_vertex, assembled.original_cell, std::vector{group});
        writer.add_step(0, 0, 0,
                        std::vector<store::ArrayValues>{{{"p", store::Association::point, 1, "Pa", "pressure"}, p}});
        writer.finish();
        const auto document = shown().document;
        const bool is_thin = std::string(type) != "patch";
        EXPECT_EQ(document["layers"].contains("iso"), !is_thin) << type;
        if (!is_thin) continue;
        EXPECT_EQ(document["layers"]["slice"]["axis"], "z") << type;
        const auto &at = document["camera"]["position"], &target = document["camera"]["target"];
        EXPECT_TRUE(at[0] == target[0] && at[1] == target[1] && at[2] > target[2]) << type << ": not from above";
    }
}

TEST_F(default_scene_of, a_run_that_blew_up_is_the_last_step_before_that) {
    test::write_small_dataset(box());
    const auto vertices = store::Dataset::open(box())->info().meshes[0].vertices;
    const std::vector<float> u(3 * vertices, 1);
    std::vector<float> p(vertices, 1);
    p[vertices / 2] = std::numeric_limits<float>::quiet_NaN();
    auto writer = store::Writer::append(box());
    const std::vector<store::ArrayValues> values{{{"p", store::Association::point, 1, "Pa", "pressure"}, p},
                                                 {{"U", store::Association::point, 3, "m/s", "velocity"}, u}};
    writer.add_step(3, 0, 0, values);
    writer.finish();
    EXPECT_EQ(shown().document["time"], 2);
}

TEST_F(default_scene_of, a_mesh_without_bodies_is_an_iso_surface_of_the_whole) {
    const test::Polyhedra input = test::zoo({{6, 6, 6}, 0, 5, 1});
    const Assembled assembled = assemble(test::view(input));
    store::Writer writer(box(), {"a generator", "m", input.vertex_count(), 0, input.cell_count(), {}});
    writer.add_mesh(assembled.mesh, assembled.original_vertex, assembled.original_cell, {});
    std::vector<float> p;
    for (std::size_t i = 0; i < assembled.mesh.positions.size(); i += 3) p.push_back(assembled.mesh.positions[i]);
    const std::vector<store::ArrayValues> values{{{"p", store::Association::point, 1, "Pa", "pressure"}, p}};
    for (const double time : {0.0, 1.0}) writer.add_step(time, 0, 0, values);
    writer.finish();
    const auto [document, looked_at] = shown();
    EXPECT_EQ(document["layers"]["iso"]["array"], "p");
    EXPECT_NEAR(document["layers"]["iso"]["values"][0].get<double>(), 3, 0.6);
    EXPECT_FALSE(document["layers"].contains("slice"));
    EXPECT_EQ(document["time"], 0);
    EXPECT_NEAR(looked_at.high[0] - looked_at.low[0], 6, 1);
}

TEST_F(default_scene_of, noise_is_an_iso_surface_of_another_array_if_there_is_one) {
    const test::Polyhedra input = test::hexahedra({{49, 49, 49}, 0, 1, 1});
    const Assembled assembled = assemble(test::view(input));
    std::vector<float> smooth, noise;
    for (std::size_t i = 0; i < assembled.mesh.positions.size(); i += 3) {
        smooth.push_back(assembled.mesh.positions[i]);
        noise.push_back(static_cast<float>(i * 7919 % 1009));
    }
    const auto array = [](const char* name) { return store::ArrayInfo{name, store::Association::point, 1, "", ""}; };
    const auto iso_of = [&](const std::vector<store::ArrayValues>& values) {
        store::Writer writer(box(), {"a generator", "m", input.vertex_count(), 0, input.cell_count(), {}}, true);
        writer.add_mesh(assembled.mesh, assembled.original_vertex, assembled.original_cell, {});
        writer.add_step(0, 0, 0, values);
        writer.finish();
        return shown().document["layers"]["iso"];
    };
    const auto other = iso_of({{array("a"), noise}, {array("b"), smooth}});
    EXPECT_EQ(other["array"], "b");
    EXPECT_EQ(other["color"]["array"], "a");
    EXPECT_EQ(iso_of({{array("a"), noise}})["array"], "a") << "there is no other array";
    EXPECT_EQ(iso_of({{array("a"), smooth}, {array("b"), smooth}})["array"], "a") << "the first";
}

} // namespace
} // namespace server::geometry
