// A cell whose value is not a finite number is left out of every layer that shows its array, and no other cell is. The
// dataset "sound" has finite values in all cells, for comparison.
#include "ciel/cell_shapes.hpp"
#include "ciel/point_interpolation.hpp"
#include "geometry/volume_cut.hpp"
#include "store/catalog.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"
#include "support/meshes.hpp"
#include "support/views.hpp"

#include <algorithm>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <set>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;
using testing::ElementsAre;

// 5 x 5 x 5 hexahedra. The value of p is the x coordinate of a cell's center.
constexpr int edge = 5;
constexpr Index in_the_middle = 62, at_the_side = 12; // ids in the imported file

class bad_cells : public testing::Test {
protected:
    bad_cells() {
        write("sound", {});
        write("bad", {in_the_middle});
        write("side", {at_the_side});
    }

    void write(const std::string& name, const std::set<Index>& wrong) {
        const Assembled made = assemble(test::view(test::hexahedra({{edge, edge, edge}})));
        const FaceMeshView mesh = made.mesh.view();
        const Topology topology(mesh);
        std::vector<float> cells;
        for (const Vec3d& center : cell_centers(topology, mesh))
            cells.push_back(static_cast<float>(center[0] + mesh.origin[0]));
        const std::vector<float> points = PointInterpolation(topology, mesh).apply(cells, 1);
        for (std::size_t i = 0; i < cells.size(); ++i)
            if (wrong.contains(made.original_cell[i])) cells[i] = std::numeric_limits<float>::infinity();
        store::ArrayInfo on_points{"p", store::Association::point, 1, "", ""};
        on_points.source.origin = store::Origin::interpolated;
        store::Writer writer(folder.path() / (name + ".ciel"), {});
        writer.add_mesh(made.mesh, made.original_vertex, made.original_cell, {});
        writer.add_step(0, 0, 0,
                        std::vector<store::ArrayValues>{{on_points, points},
                                                        {{"cell:p", store::Association::cell, 1, "", ""}, cells}});
        writer.finish();
    }

    std::shared_ptr<const Geometry> show(const std::string& name, json layers) {
        SceneGeometry geometry{Algorithm::signatures};
        return geometry.update({scene::parse({{"dataset", name}, {"layers", std::move(layers)}}), catalog.open(name)});
    }
    // Returns the id in the imported file of each polygon's cell.
    std::vector<Index> cells_of(const std::string& name, const Drawable& drawable) {
        const auto ids = catalog.open(name)->dataset()->original_cell(0);
        std::vector<Index> cells;
        for (const Index cell : drawable.shape->surface.polygon_cell) cells.push_back(ids[cell]);
        return cells;
    }
    // Expects that exactly the polygons of `cell` are missing. Returns their number.
    std::size_t missing_of(const std::string& name, Index cell, const json& layer) {
        const auto whole = show("sound", {{"a", layer}}), without = show(name, {{"a", layer}});
        EXPECT_EQ(whole->drawables.size(), without->drawables.size());
        const std::vector<Index> all = cells_of("sound", whole->drawables[0]);
        std::vector<Index> expected = all;
        std::erase(expected, cell);
        EXPECT_EQ(cells_of(name, without->drawables[0]), expected) << layer;
        EXPECT_EQ(without->triangles, without->drawables[0].shape->indices.size() / 3);
        return all.size() - expected.size();
    }

    test::Folder folder;
    store::Catalog catalog{{folder.path()}};
};

const json by_points{{"array", "p"}}, by_cells{{"array", "cell:p"}};

json layer_of(const json& kind, const json& color) {
    json layer = kind;
    layer["color"] = color;
    return layer;
}

const json iso{{"type", "iso"}, {"array", "p"}, {"values", {2.4}}};
const json slice{{"type", "slice"}, {"axis", "y"}, {"value", 2.3}};
const json boundary{{"type", "surface"}};

TEST_F(bad_cells, are_left_out_of_surfaces_slices_and_boundaries) {
    EXPECT_EQ(missing_of("bad", in_the_middle, iso), 1U) << "one color, of its own array";
    EXPECT_EQ(missing_of("bad", in_the_middle, layer_of(iso, by_points)), 1U);
    for (const json& color : {by_points, by_cells}) {
        EXPECT_EQ(missing_of("bad", in_the_middle, layer_of(slice, color)), 1U);
        EXPECT_EQ(missing_of("side", at_the_side, layer_of(boundary, color)), 1U);
        EXPECT_EQ(missing_of("bad", in_the_middle, layer_of(boundary, color)), 0U) << "it is inside";
    }
    EXPECT_EQ(cells_of("bad", show("bad", {{"a", slice}})->drawables[0]),
              cells_of("sound", show("sound", {{"a", slice}})->drawables[0]))
        << "shows no array";
}

TEST_F(bad_cells, are_left_out_of_caps_and_thresholds) {
    const json clip{{"type", "clip"}, {"axis", "y"}, {"value", 2.3}};
    const auto capped = show("bad", {{"a", layer_of(boundary, by_points)}, {"c", clip}});
    ASSERT_EQ(capped->drawables.size(), 2U);
    EXPECT_EQ(capped->drawables[1].shape->surface.polygon_cell.size(), edge * edge - 1U);
    json chosen = boundary;
    chosen["threshold"] = {{"array", "p"}, {"range", {-10, 10}}};
    const auto kept = show("bad", {{"a", chosen}});
    EXPECT_EQ(kept->drawables[0].shape->surface.polygon_cell.size(), 6U * edge * edge + 6U) << "a hole inside";
}

TEST_F(bad_cells, are_left_out_of_edges_and_contour_lines) {
    json layer = layer_of(slice, by_points);
    layer["edges"] = json::object();
    layer["contours"] = {{"array", "p"}, {"values", {2.4}}};
    const auto whole = show("sound", {{"a", layer}}), without = show("bad", {{"a", layer}});
    ASSERT_EQ(whole->drawables.size(), 3U);
    EXPECT_EQ(without->drawables[1].indices().size(), whole->drawables[1].indices().size())
        << "its edges are those of its neighbours";
    EXPECT_EQ(without->drawables[2].indices().size() + 2, whole->drawables[2].indices().size()) << "one line";
}

TEST_F(bad_cells, are_left_out_of_volumes) {
    const json volume{{"type", "volume"}, {"array", "p"}, {"slices", edge}};
    const auto filled = [&](const std::string& name) {
        const auto shown = show(name, {{"v", volume}});
        std::size_t triangles = 0;
        for (const color::SlabTriangles& slab : shown->volumes.at(0).slabs->slices)
            triangles += slab.triangles.size() / 3;
        return std::pair(triangles, shown->volumes.at(0).slabs->boundary->triangles.size() / 3);
    };
    const auto whole = filled("sound"), without = filled("bad");
    EXPECT_EQ(without.first + 2, whole.first) << "the two triangles of one quadrilateral";
    EXPECT_EQ(without.second, whole.second + 12) << "the six sides of the hole";
}

TEST_F(bad_cells, that_are_all_there_is_say_why_nothing_is_seen) {
    std::set<Index> all;
    for (Index cell = 0; cell < edge * edge * edge; ++cell) all.insert(cell);
    write("burst", all);
    for (const json& layer : {layer_of(slice, by_cells), layer_of(boundary, by_cells),
                              json{{"type", "volume"}, {"array", "p"}, {"slices", 5}}}) {
        const auto shown = show("burst", {{"a", layer}});
        ASSERT_EQ(shown->empty.size(), 1U) << layer;
        EXPECT_EQ(shown->empty[0].reason, "No cell of the layer has a number for the array of the layer at this time.")
            << layer;
    }
}

TEST_F(bad_cells, are_counted_in_words) {
    for (const json& layer : {iso, layer_of(slice, by_points)}) {
        const auto shown = show("bad", {{"a", layer}, {"b", layer}});
        EXPECT_THAT(shown->remarks, ElementsAre("1 cell has no number for p at this time and is left out"));
        EXPECT_TRUE(show("sound", {{"a", layer}})->remarks.empty());
    }
    const auto shown = show("bad", {{"a", layer_of(slice, by_points)}});
    EXPECT_THAT(shown->drawables[0].legend_lines, ElementsAre("cells: 0.5 to 4.5", "1 cell left out"));
}

} // namespace
} // namespace server::geometry
