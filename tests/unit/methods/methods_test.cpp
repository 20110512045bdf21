// Methods about the contract, the server and its datasets.
#include "methods.hpp"

#include <fstream>
#include <gmock/gmock.h>

namespace ciel::test {
using namespace server;
namespace {

TEST_F(Methods, discover_is_the_contract_and_all_its_methods_exist) {
    const json document = client.call("rpc.discover");
    std::ifstream contract(CIEL_SOURCE_DIR "/protocol/openrpc.json");
    EXPECT_EQ(document, json::parse(contract));
    ASSERT_FALSE(document["methods"].empty());
    for (const json& method : document["methods"])
        EXPECT_NE(client.error_code(method["name"], {{"no such param", 1}}), -32601) << method["name"];
}

TEST_F(Methods, server_info) {
    const json info = client.call("server.info");
    EXPECT_FALSE(info["gl_renderer"].get<std::string>().empty());
    EXPECT_EQ(info["algorithm"], chosen_algorithm() == Algorithm::propagation ? "propagation" : "signatures");
    EXPECT_EQ(info["engine"], info["algorithm"]) << "the deprecated name of the member";
    const limits::Limits& limits = server.limits();
    EXPECT_EQ(info["limits"].size(), limits::limit_rows().size());
    for (const auto& row : limits::limit_rows()) EXPECT_EQ(info["limits"][row.name], limits.*row.member) << row.name;
    EXPECT_THAT(info["color_maps"], testing::Contains("viridis"));
    EXPECT_EQ(info["protocol"].dump(), R"({"major":1,"minor":1})");
    EXPECT_EQ(info["layer_types"], json({"iso", "slice", "surface", "outline", "clip", "edges", "points", "volume"}));
    EXPECT_EQ(info["streams"], json({"image", "geometry"}));
}

TEST_F(Methods, dataset_describe) {
    const json box = client.call("dataset.describe", {{"dataset", "box"}});
    EXPECT_EQ(box["times"], json({0, 1, 2}));
    EXPECT_EQ(box["bounds"], json({1000, 1006, 0, 6, -50, -44}));
    EXPECT_EQ(box["length_units"], "m");
    std::map<std::string, json> arrays;
    for (const json& array : box["arrays"]) arrays[array["name"]] = array;
    EXPECT_EQ(arrays.size(), 4U);
    EXPECT_EQ(arrays["p"]["range"], json::array({0, 56})); // the range covers all steps
    EXPECT_EQ(arrays["U"]["scalars"].size(), 4U);
    EXPECT_EQ(arrays["cell:q"]["scalars"], json::array({"cell:q"}));
    EXPECT_EQ(arrays["late"]["times"], json::array({2}));
    EXPECT_EQ(box["groups"].size(), 3U);
    EXPECT_GT(box["mesh"]["half_edges"], 1000);
    EXPECT_EQ(box["default_scene"]["dataset"], "box");
    EXPECT_EQ(client.error_code("dataset.describe", {{"dataset", "../box"}}), -32001);
    EXPECT_EQ(client.error_code("dataset.describe", {{"dataset", "/etc/passwd"}}), -32001);
}

// Values of cell:q are cell ids.
TEST_F(Methods, tell_which_cells_have_the_extremes) {
    const json box = client.call("dataset.describe", {{"dataset", "box"}});
    std::map<std::string, json> arrays;
    for (const json& array : box["arrays"]) arrays[array["name"]] = array;
    const json of_all = arrays["cell:q"];
    const json highest = of_all["extremes"]["highest"];
    EXPECT_EQ(highest["cell"], highest["value"]);
    EXPECT_GT(highest["cell"], 50);
    EXPECT_EQ(highest["time"], 0) << "the first of the steps that have it";
    EXPECT_EQ(of_all["origin"], "original");
    EXPECT_EQ(of_all["invalid"], 0);
    EXPECT_FALSE(arrays["p"].contains("extremes")) << "it was not made from cells";

    const json histogram = client.call("dataset.histogram", {{"dataset", "box"}, {"array", "cell:q"}, {"time", 1}});
    EXPECT_EQ(histogram["cells"]["highest"]["cell"], highest["cell"]);
    EXPECT_EQ(histogram["cells"]["highest"]["time"], 1);
    EXPECT_FALSE(client.call("dataset.histogram", {{"dataset", "box"}, {"array", "p"}}).contains("cells"));

    const json scene{{"dataset", "box"}};
    const json probed = client.call("probe.point", {{"scene", scene}, {"position", highest["place"]}});
    EXPECT_EQ(probed["cell"], highest["cell"]) << "its place is in it";
    EXPECT_EQ(probed["values"]["cell:q"], highest["value"]);
    EXPECT_EQ(probed["extremes"]["cell:q"]["highest"]["cell"], highest["cell"]);
    EXPECT_FALSE(probed.contains("solver_cell")) << "the source had none";
}

TEST_F(Methods, histogram_counts_every_vertex_once) {
    const json vertices = client.call("dataset.describe", {{"dataset", "box"}})["mesh"]["vertices"];
    json params{{"dataset", "box"}, {"array", "p"}, {"bins", 10}};
    const auto total = [](const json& h) {
        int sum = h["invalid"].get<int>() + h["below"].get<int>() + h["above"].get<int>();
        for (const json& count : h["counts"]) sum += count.get<int>();
        return sum;
    };
    const json all = client.call("dataset.histogram", params);
    EXPECT_EQ(all["range"], json({0, 36}));
    EXPECT_EQ(total(all), vertices);
    EXPECT_EQ(all["below"], 0);
    EXPECT_EQ(all["above"], 0);
    params["range"] = {10, 20};
    const json part = client.call("dataset.histogram", params);
    EXPECT_EQ(total(part), vertices);
    EXPECT_GT(part["below"], 0);
    EXPECT_GT(part["above"], 0);
    params["range"] = {-1.5e308, 1.5e308};
    EXPECT_EQ(client.call("dataset.histogram", params)["counts"][5], vertices) << "all lie just above the middle";
    params["range"] = {20, 10};
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32602);
    params["array"] = "nope";
    params.erase("range");
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32001);
    params["array"] = "late"; // the array does not exist at the first time
    EXPECT_EQ(client.error_code("dataset.histogram", params), -32005);
}

} // namespace
} // namespace ciel::test
