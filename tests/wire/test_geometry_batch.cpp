// Batches put together again are the mesh that was sent.
#include "wire/geometry_batch.hpp"

#include <cstring>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace ciel::wire {
namespace {

struct Sheet { // n x n squares
    std::vector<Vec3f> positions, normals;
    std::vector<float> scalars;
    std::vector<Index> indices;

    explicit Sheet(Index n) {
        for (Index j = 0; j <= n; ++j)
            for (Index i = 0; i <= n; ++i) {
                positions.push_back({static_cast<float>(i), static_cast<float>(j), 0.5F});
                normals.push_back({0, static_cast<float>(i), 1});
                scalars.push_back(static_cast<float>(i + j * 1000));
            }
        for (Index j = 0; j < n; ++j)
            for (Index i = 0; i < n; ++i) {
                const Index a = j * (n + 1) + i;
                for (const Index corner : {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1}) indices.push_back(corner);
            }
    }
    [[nodiscard]] GeometryMesh mesh(std::string layer) const {
        GeometryMesh mesh;
        mesh.layer = std::move(layer);
        mesh.positions = positions;
        mesh.normals = normals;
        mesh.scalars = scalars;
        mesh.indices = indices;
        mesh.map = "viridis";
        mesh.range = {-1.5F, 1e-7F};
        mesh.color = {0.25F, 0.5F, 1, 0.75F};
        return mesh;
    }
};

struct Decoded {
    nlohmann::json description;
    std::vector<Vec3f> positions, normals;
    std::vector<float> scalars;
    std::vector<Index> indices;
};

template <typename T>
std::vector<T> take(std::span<const std::uint8_t>& bytes, std::size_t count) {
    if (bytes.size() / sizeof(T) < count) throw std::runtime_error("the batch is shorter than it says");
    std::vector<T> values(count);
    if (count > 0) std::memcpy(values.data(), bytes.data(), count * sizeof(T)); // no data: a null pointer
    bytes = bytes.subspan(count * sizeof(T));
    return values;
}

Decoded decode(std::span<const std::uint8_t> bytes) {
    Decoded out;
    const auto json_bytes = take<std::uint32_t>(bytes, 1)[0];
    EXPECT_EQ(json_bytes % 4, 0U);
    const auto text = take<char>(bytes, json_bytes);
    out.description = nlohmann::json::parse(text.begin(), text.end());
    const std::size_t vertices = out.description["vertices"];
    out.positions = take<Vec3f>(bytes, vertices);
    if (out.description["normals"]) out.normals = take<Vec3f>(bytes, vertices);
    if (out.description["scalars"]) out.scalars = take<float>(bytes, vertices);
    out.indices = take<Index>(bytes, out.description["indices"]);
    EXPECT_TRUE(bytes.empty());
    return out;
}

TEST(GeometryBatch, PutTogetherIsTheMesh) {
    const Sheet sheet(40);
    const std::vector<GeometryMesh> meshes{sheet.mesh("a"), sheet.mesh("quote\" \\ \n\x01 \xc3\xa9")};
    for (const std::size_t max_vertices : {std::size_t{3}, std::size_t{100}, batch_vertices}) {
        const auto payloads = encode_geometry(meshes, {1e6, -2.5, 0.1}, max_vertices);
        std::size_t at = 0;
        std::size_t number = 0;
        for (const GeometryMesh& mesh : meshes) {
            std::size_t corner = 0;
            while (corner < mesh.indices.size()) {
                ASSERT_LT(at, payloads.size());
                const Decoded batch = decode(payloads[at++]);
                EXPECT_EQ(batch.description["layer"], mesh.layer);
                EXPECT_EQ(batch.description["kind"], "triangles");
                EXPECT_EQ(batch.description["batch"], number++);
                EXPECT_EQ(batch.description["batches"], payloads.size());
                EXPECT_EQ(batch.description["origin"], nlohmann::json({1e6, -2.5, 0.1}));
                EXPECT_EQ(batch.description["range"][1].get<float>(), 1e-7F);
                EXPECT_EQ(batch.description["color"], nlohmann::json({0.25, 0.5, 1, 0.75}));
                EXPECT_EQ(batch.description["lit"], true);
                EXPECT_LE(batch.positions.size(), max_vertices);
                for (const Index local : batch.indices) {
                    ASSERT_LT(local, batch.positions.size());
                    const Index global = mesh.indices[corner++];
                    EXPECT_EQ(batch.positions[local], mesh.positions[global]);
                    EXPECT_EQ(batch.normals[local], mesh.normals[global]);
                    EXPECT_EQ(batch.scalars[local], mesh.scalars[global]);
                }
            }
        }
        EXPECT_EQ(at, payloads.size());
    }
    EXPECT_EQ(encode_geometry(meshes, {}).size(), 2U) << "what fits in one batch is one";
}

TEST(GeometryBatch, VerticesAreSharedInsideABatch) {
    const Sheet sheet(40);
    const auto payloads = encode_geometry(std::vector{sheet.mesh("a")}, {});
    EXPECT_EQ(decode(payloads.at(0)).positions.size(), sheet.positions.size());
}

TEST(GeometryBatch, LinesWithoutNormalsOrScalars) {
    const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const std::vector<Index> indices{0, 1, 1, 2};
    GeometryMesh mesh;
    mesh.layer = "outline";
    mesh.positions = positions;
    mesh.indices = indices;
    mesh.lines = true;
    mesh.lit = false;
    const Decoded batch = decode(encode_geometry(std::vector{mesh}, {}).at(0));
    EXPECT_EQ(batch.description["kind"], "lines");
    EXPECT_EQ(batch.description["lit"], false);
    EXPECT_EQ(batch.positions, positions);
    EXPECT_EQ(batch.indices, indices);
}

TEST(GeometryBatch, NothingIsOneMessageThatSaysSo) {
    const Sheet sheet(2);
    GeometryMesh empty = sheet.mesh("gone");
    empty.indices = {};
    for (const auto& meshes : {std::vector<GeometryMesh>{}, std::vector{empty}}) {
        const auto payloads = encode_geometry(meshes, {});
        ASSERT_EQ(payloads.size(), 1U);
        const Decoded batch = decode(payloads[0]);
        EXPECT_EQ(batch.description["batches"], 0);
        EXPECT_EQ(batch.description["vertices"], 0);
    }
}

TEST(GeometryBatch, ArraysThatDoNotFitAreRefused) {
    const Sheet sheet(2);
    const std::vector<Index> beyond{0, 1, 9};
    struct Row {
        const char* name;
        void (*spoil)(GeometryMesh&, const std::vector<Index>&);
    };
    for (const Row& row :
         {Row{"normals", [](GeometryMesh&m, const std::vector<Index>&) { m.normals = m.normals.first(1); }},
          Row{"scalars", [](GeometryMesh&m, const std::vector<Index>&) { m.scalars = m.scalars.first(1); }},
          Row{"corners", [](GeometryMesh&m, const std::vector<Index>&) { m.indices = m.indices.first(4); }},
          Row{"beyond", [](GeometryMesh&m, const std::vector<Index>&b) { m.indices = b; }}}) {
        GeometryMesh mesh = sheet.mesh("a");
        row.spoil(mesh, beyond);
        EXPECT_THAT([&] { static_cast<void>(encode_geometry(std::vector{mesh}, {})); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr("layer 'a'")))
            << row.name;
    }
}

TEST(GeometryBatch, LinesPointsAndClipPlanesAreDescribed) {
    const Sheet sheet(2);
    const std::vector<std::array<float, 4>> planes{{1, 0, 0, 0.5F}, {0, -0.25F, 1, -2}};
    const std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7};
    GeometryMesh points = sheet.mesh("p");
    points.normals = {};
    points.indices = all;
    points.points = true;
    points.line_width = 7.5F;
    points.clip = planes;
    GeometryMesh lines = points;
    lines.points = false;
    lines.lines = true;
    lines.clip = {};
    const auto payloads = encode_geometry(std::vector{points, lines, sheet.mesh("t")}, {1, 2, 3});
    ASSERT_EQ(payloads.size(), 3U);
    const Decoded first = decode(payloads[0]);
    EXPECT_EQ(first.description["kind"], "points");
    EXPECT_EQ(first.description["width"], 7.5);
    EXPECT_EQ(first.description["clip"], nlohmann::json::parse("[[1, 0, 0, 0.5], [0, -0.25, 1, -2]]"));
    EXPECT_EQ(first.indices, all);
    EXPECT_EQ(decode(payloads[1]).description["kind"], "lines");
    EXPECT_FALSE(decode(payloads[1]).description.contains("clip"));
    EXPECT_FALSE(decode(payloads[2]).description.contains("width"));
    EXPECT_EQ(encode_geometry(std::vector{points}, {}, 3).size(), 3U) << "a point may stand alone in a batch";
}

} // namespace
} // namespace ciel::wire
