// Layers, probes and histograms of a stored dataset allocate no array with a number for each cell or vertex. A
// threshold and a volume have a byte for each cell, and a volume has a gradient for each vertex.
#include "allocations/counted_new.hpp"
#include "ciel/cell_locator.hpp"
#include "geometry/default_scene.hpp"
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <cmath>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
namespace {

using nlohmann::json;

constexpr int side = 80;
constexpr std::size_t cells = std::size_t{side} * side * side, vertices = (side + 1UL) * (side + 1) * (side + 1);
// A boundary has 7.5 % as many faces as the mesh has cells. Its triangles need 1.8 bytes for each cell of the mesh,
// more while a vector grows.
constexpr std::size_t of_surfaces = 2 * cells, of_boundaries = 4 * cells;

void write_cubes(const std::filesystem::path& directory) {
    const ciel::Assembled made = ciel::assemble(ciel::test::view(ciel::test::hexahedra({{side, side, side}})));
    const std::vector<float>& places = made.mesh.positions;
    std::vector<float> slope, of_cells;
    for (std::size_t i = 0; i < places.size(); i += 3) slope.push_back(places[i] + 0.3F * places[i + 1]);
    for (const ciel::Index cell : made.original_cell) of_cells.push_back(static_cast<float>(cell));
    store::Writer writer(directory, {"cubes.vtu", "m", slope.size(), 12, cells, {}});
    writer.add_mesh(made.mesh, made.original_vertex, made.original_cell, {});
    const std::vector<store::ArrayValues> arrays{{{"p", store::Association::point, 1, "Pa", ""}, slope},
                                                 {{"U", store::Association::point, 3, "m/s", ""}, places},
                                                 {{"id", store::Association::cell, 1, "", ""}, of_cells}};
    writer.add_step(0, 0, 0, arrays);
    writer.finish();
}

class LongAsTheMesh : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<ciel::test::Folder>();
        write_cubes(folder->path() / "cubes.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }

    static std::unique_ptr<ciel::test::Folder> folder;
    store::Catalog catalog{{folder->path()}};
};
std::unique_ptr<ciel::test::Folder> LongAsTheMesh::folder;

json with(json layer, const char* member, json value) {
    layer[member] = std::move(value);
    return layer;
}
json turned(double by) {
    return {{"type", "slice"}, {"origin", {40, 40, 40}}, {"normal", {std::sin(by), 0, std::cos(by)}}};
}

TEST_F(LongAsTheMesh, NoArrayOfALayerIs) {
    const json iso{{"type", "iso"}, {"array", "p"}, {"values", {40.3}}};
    const json range{{"array", "p"}, {"range", {20, 60}}};
    struct Case {
        const char* name;
        std::vector<json> layers; // shown one after the other
        std::size_t bytes = of_surfaces;
    };
    const std::vector<Case> cases{
        {"iso", {iso, with(iso, "values", {41.7})}},
        {"iso, colored by another array", {with(iso, "color", {{"array", "U:magnitude"}})}},
        {"iso, colored by cells", {with(iso, "color", {{"array", "id"}})}},
        {"iso, edges", {with(iso, "edges", json::object())}},
        {"slice", {{{"type", "slice"}, {"axis", "z"}, {"value", 40.5}}}},
        {"slice that turns", {turned(0.1), turned(0.2), turned(0.3)}},
        {"slice, contours", {with(turned(0.1), "contours", {{"array", "p"}, {"values", {20, 60}}})}},

        {"boundary", {{{"type", "surface"}}}, of_boundaries},
        {"threshold", {{{"type", "surface"}, {"threshold", range}}}, of_boundaries},
        {"edges of a threshold", {{{"type", "edges"}, {"threshold", range}}}, of_boundaries},
        {"points", {{{"type", "points"}, {"most", 1000}}}, of_boundaries},
        {"points of a threshold", {{{"type", "points"}, {"most", 1000}, {"threshold", range}}}, of_boundaries},
    };
    for (const Case& each : cases) {
        const auto loaded = catalog.open("cubes");
        SceneGeometry geometry{ciel::Algorithm::signatures}; // the lists of propagation may be as long
        const ciel::test::LargeAllocations large(each.bytes);
        for (const json& layer : each.layers) {
            const json layers{{"a", layer}, {"clip", {{"type", "clip"}, {"axis", "y"}, {"value", 70}, {"caps", true}}}};
            const auto shown = geometry.update({scene::parse({{"dataset", "cubes"}, {"layers", layers}}), loaded});
            EXPECT_FALSE(shown->drawables.empty()) << layer;
        }
        EXPECT_EQ(ciel::test::LargeAllocations::count(), 0U) << each.name;
    }
}

TEST_F(LongAsTheMesh, OnlyTheGradientsOfAVolumeAre) {
    const auto loaded = catalog.open("cubes");
    SceneGeometry geometry{ciel::Algorithm::signatures};
    const json layers{{"a", {{"type", "volume"}, {"array", "p"}, {"slices", 40}}}};
    const ciel::test::LargeAllocations large(sizeof(float) * vertices);
    const auto shown = geometry.update({scene::parse({{"dataset", "cubes"}, {"layers", layers}}), loaded});
    EXPECT_EQ(shown->volumes.size(), 1U);
    EXPECT_EQ(ciel::test::LargeAllocations::count(), 1U); // 12 bytes for each vertex
}

TEST_F(LongAsTheMesh, NoArrayOfAProbeAHistogramOrTheFirstSceneIs) {
    const auto loaded = catalog.open("cubes");
    const ciel::test::LargeAllocations large(of_surfaces);
    EXPECT_NE(loaded->locator(0)->cell_at({40.5, 40.5, 40.5}), ciel::none);
    for (const char* name : {"p", "U:y", "U:magnitude", "id"}) (void)loaded->histogram(name, 0, 64, std::nullopt);
    (void)default_scene(*loaded, "cubes");
    EXPECT_EQ(ciel::test::LargeAllocations::count(), 0U);
}

} // namespace
} // namespace server::geometry
