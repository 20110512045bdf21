// Names with control characters are escaped in error messages. A zero byte would cut the message short.
#include "ciel/printable.hpp"
#include "geometry/scene_geometry.hpp"
#include "store/catalog.hpp"
#include "support/small_dataset/small_dataset.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace server::geometry {
using namespace ciel;
namespace {

using nlohmann::json;

const std::string name("a\0b\x1b[1m", 7);
const std::string shown = "a\\u0000b\\u001b[1m";

TEST(PrintableNames, HaveControlCharactersAsJsonWritesThem) {
    EXPECT_EQ(printable(name), shown);
    EXPECT_EQ(printable("\n\x7f"), "\\u000a\\u007f");
    for (const char* plain : {"", "p", "ν = 1.5 µm²/s", "a\\b \"c\"", "速度"}) EXPECT_EQ(printable(plain), plain);
}

std::string lacking_in_scene_of(const std::string& id, const std::shared_ptr<store::LoadedDataset>& loaded) {
    const json layer{{"type", "surface"}, {"color", {{"array", "late"}}}};
    SceneGeometry geometry{Extraction{}};
    const auto shows = geometry.update({scene::parse({{"dataset", "box"}, {"layers", {{id, layer}}}}), loaded});
    try {
        require_complete(*shows);
    } catch (const store::NotWritten& error) {
        return error.what();
    }
    return "nothing is lacking";
}

TEST(PrintableNames, AreInWholeSentences) {
    const test::Folder folder;
    test::write_small_dataset(folder.path() / "box.ciel");
    store::Catalog catalog{{folder.path()}};
    const auto loaded = catalog.open("box");
    const auto refused = [&](const std::string& id, const json& layer) -> std::string {
        try {
            SceneGeometry geometry{Extraction{}};
            (void)geometry.update({scene::parse({{"dataset", "box"}, {"layers", {{id, layer}}}}), loaded});
        } catch (const std::exception& error) {
            return error.what();
        }
        return "nothing was refused";
    };
    EXPECT_EQ(refused("a", {{"type", "surface"}, {"color", {{"array", name}}}}),
              "dataset 'box' has no scalar '" + shown + "'; it has U:magnitude, U:x, U:y, U:z, p, late");
    EXPECT_TRUE(refused("a", {{"type", "surface"}, {"color", {{"array", "p"}, {"map", name}}}})
                    .starts_with("there is no color map " + shown + "; choose one of "));
    EXPECT_EQ(refused("a", {{"type", "surface"}, {"groups", {name}}}),
              "there is no patch " + shown + "; choose one of left, body");
    EXPECT_TRUE(refused("a", {{"type", "surface"}, {name, 1}})
                    .starts_with("/layers/a/" + shown + " is not a known member; the known members are "));
    EXPECT_EQ(refused(name, {{"type", "surface"}, {"opacity", 7}}), "/layers/" + shown + "/opacity must be at most 1");
    const auto late = lacking_in_scene_of(name, loaded);
    EXPECT_EQ(late, "layer " + shown + " has no colors: 'late' has no values at time 0; it has values at 2");
    try {
        (void)catalog.open(name);
        FAIL() << "there is no such dataset";
    } catch (const Error& error) {
        EXPECT_EQ(error.what(), "there is no dataset '" + shown + "'; there are: box");
    }
}

} // namespace
} // namespace server::geometry
