// The layers that a line of sight crosses, at known positions. The box goes from 0 to 6 relative to box_origin and has
// a hole from 2 to 4. The hole's sides are the patch "body"; the patch "left" is at x = 0.
#include "probe/sight.hpp"

#include "store/catalog.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::probe {
using namespace ciel;
namespace {

using nlohmann::json;

struct Seen {
    double x = 0; // relative to box_origin
    std::string layer;
    std::optional<std::string> patch;
    bool operator==(const Seen&) const = default;
};

class Sight : public testing::Test {
protected:
    static constexpr geometry::ViewSize size{101, 101, 1};
    static constexpr std::array<double, 2> middle{50.5, 50.5};

    void show(json layers, bool parallel = false) {
        const Vec3d& o = test::box_origin;
        const json camera{{"position", {o[0] - 20, o[1] + 3.1, o[2] + 2.7}},
                          {"target", {o[0] + 3, o[1] + 3.1, o[2] + 2.7}},
                          {"parallel", parallel},
                          {"parallel_height", 10}};
        checked.emplace(scene::parse({{"dataset", "box"}, {"camera", camera}, {"layers", std::move(layers)}}),
                        catalog.open("box"));
        shown = geometry.update(*checked);
    }
    std::vector<Seen> along(std::array<double, 2> pixel = middle) {
        std::vector<Seen> seen;
        for (const Crossing& crossing : crossings(*shown, *checked, size, pixel))
            seen.push_back({std::round(1e3 * (crossing.position[0] - test::box_origin[0])) / 1e3,
                            shown->drawables[crossing.drawable].layer, patch_of(crossing, *shown, *checked)});
        return seen;
    }

    test::Folder folder;
    store::Catalog catalog = [this] {
        test::write_small_dataset(folder / "box.ciel");
        return store::Catalog{{folder.path()}};
    }();
    geometry::SceneGeometry geometry{test::chosen_algorithm()};
    std::optional<scene::CheckedScene> checked;
    std::shared_ptr<const geometry::Geometry> shown;
};

const json whole{{"type", "surface"}};
const json body{{"type", "surface"}, {"groups", {"body"}}};
const json slice{{"type", "slice"}, {"axis", "x"}, {"value", 1001}};

TEST_F(Sight, meets_surfaces_in_the_order_of_their_distance_and_names_their_patches) {
    for (const bool parallel : {false, true}) {
        show({{"w", whole}, {"s", slice}}, parallel);
        const std::vector<Seen> expected{
            {0, "w", "left"}, {1, "s", {}}, {2, "w", "body"}, {4, "w", "body"}, {6, "w", {}}};
        EXPECT_EQ(along(), expected);
    }
}

TEST_F(Sight, meets_nothing_beside_the_surfaces) {
    show({{"w", whole}});
    EXPECT_TRUE(along({0, 0}).empty());
    EXPECT_TRUE(along({-1, 50}).empty());
    EXPECT_TRUE(along({50, 101}).empty());
}

TEST_F(Sight, passes_through_what_is_cut_away_or_hidden_or_no_polygon) {
    json hidden = whole;
    hidden["visible"] = false;
    json clear = whole;
    clear["opacity"] = 0;
    show({{"b", body}, {"h", hidden}, {"c", clear}, {"e", {{"type", "edges"}}}, {"o", {{"type", "outline"}}}});
    EXPECT_EQ(along(), (std::vector<Seen>{{2, "b", "body"}, {4, "b", "body"}}));
    show({{"b", body}, {"k", {{"type", "clip"}, {"axis", "x"}, {"value", 1003}, {"invert", true}, {"caps", false}}}});
    EXPECT_EQ(along(), (std::vector<Seen>{{4, "b", "body"}}));
}

TEST_F(Sight, the_crossing_at_a_position_is_the_nearest_within_the_error_of_the_depth_buffer) {
    show({{"w", whole}, {"s", slice}});
    const auto found = crossings(*shown, *checked, size, middle);
    const auto at = [&](double x) {
        return crossing_at(found, *shown,
                           {test::box_origin[0] + x, test::box_origin[1] + 3.1, test::box_origin[2] + 2.7});
    };
    ASSERT_TRUE(at(1.005));
    EXPECT_EQ(shown->drawables[at(1.005)->drawable].layer, "s");
    EXPECT_FALSE(at(1.5)) << "a line or a point in front of the surfaces";
}

} // namespace
} // namespace server::probe
