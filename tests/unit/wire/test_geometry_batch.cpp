// Decoded geometry batches equal the encoded mesh.
#include "wire/batches/geometry_batch.hpp"

#include "decode_geometry.hpp"
#include "wire/batches/quantize.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

namespace server::wire {
using namespace ciel;
namespace {

struct Sheet { // a square sheet of n x n quadrilaterals
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
    [[nodiscard]] Primitives primitives(std::string layer) const {
        Primitives primitives;
        primitives.layer = std::move(layer);
        primitives.positions = positions;
        primitives.normals = normals;
        primitives.scalars = scalars;
        primitives.indices = indices;
        primitives.map = "viridis";
        primitives.range = {-1.5F, 1e-7F};
        primitives.color = {0.25F, 0.5F, 1, 0.75F};
        return primitives;
    }
};

constexpr double step = 1.0 / 64;

DecodedBatch decode(std::span<const std::uint8_t> payload) { return GeometryClient().decode(payload); }

// Expects the same triangles. The codec may rotate the corners of a triangle.
void expect_same_corners(const DecodedBatch& batch, std::size_t first, std::span<const Vec3f> sent) {
    std::vector<Vec3f> got;
    for (std::size_t corner = 0; corner < sent.size(); ++corner)
        got.push_back(batch.positions.at(batch.indices[first + corner]));
    for (std::size_t turn = 0; turn < sent.size(); ++turn) {
        if (std::equal(got.begin(), got.end(), sent.begin())) return;
        std::rotate(got.begin(), got.begin() + 1, got.end());
    }
    ADD_FAILURE() << "triangle " << first / 3 << " is another one";
}

std::vector<std::uint8_t> bytes_of(const EncodedGeometry& encoded) {
    std::vector<std::uint8_t> bytes;
    for (const auto& payload : encoded.payloads) bytes.insert(bytes.end(), payload.begin(), payload.end());
    return bytes;
}

TEST(GeometryBatch, PutTogetherIsTheMesh) {
    const Sheet sheet(40); // positions are on the quantization grid, so nothing is rounded
    const std::vector<Primitives> all{sheet.primitives("a"), sheet.primitives("quote\" \\ \n\x01 \xc3\xa9")};
    for (const std::size_t max_vertices : {std::size_t{3}, std::size_t{100}, batch_vertices}) {
        const auto [payloads, ids] = encode_geometry(all, {1e6, -2.5, 0.1}, step, {}, max_vertices);
        std::size_t at = 0;
        for (const Primitives& primitives : all) {
            std::size_t corner = 0;
            while (corner < primitives.indices.size()) {
                ASSERT_LT(at, payloads.size());
                const DecodedBatch batch = decode(payloads[at]);
                EXPECT_EQ(batch.description["layer"], primitives.layer);
                EXPECT_EQ(batch.description["kind"], "triangles");
                EXPECT_EQ(batch.description["batch"], at++);
                EXPECT_EQ(batch.description["batches"], payloads.size());
                EXPECT_EQ(batch.description["origin"], nlohmann::json({1e6, -2.5, 0.1}));
                EXPECT_EQ(batch.description["range"][1].get<float>(), 1e-7F);
                EXPECT_EQ(batch.description["color"], nlohmann::json({0.25, 0.5, 1, 0.75}));
                EXPECT_EQ(batch.description["lit"], true);
                EXPECT_LE(batch.positions.size(), max_vertices);
                for (std::size_t first = 0; first < batch.indices.size(); first += 3) {
                    std::vector<Vec3f> sent;
                    for (const Index v : primitives.indices.subspan(corner + first, 3))
                        sent.push_back(primitives.positions[v]);
                    expect_same_corners(batch, first, sent);
                }
                for (std::size_t i = 0; i < batch.positions.size(); ++i) {
                    const auto found = std::find(sheet.positions.begin(), sheet.positions.end(), batch.positions[i]);
                    ASSERT_NE(found, sheet.positions.end());
                    const auto vertex = static_cast<std::size_t>(found - sheet.positions.begin());
                    EXPECT_EQ(batch.values[i], primitives.scalars[vertex]);
                }
                corner += batch.indices.size();
            }
        }
        EXPECT_EQ(at, payloads.size());
    }
    EXPECT_EQ(encode_geometry(all, {}, step).payloads.size(), 2U) << "what fits in one batch is one";
}

// A wavy sheet with triangles of a few grid steps, similar to an iso-surface.
struct Wave : Sheet {
    explicit Wave(Index n) : Sheet(n) {
        for (std::size_t i = 0; i < positions.size(); ++i) {
            auto& [x, y, z] = positions[i];
            z = 8 * std::sin(0.13F * x) * std::cos(0.11F * y);
            const float dx = 8 * 0.13F * std::cos(0.13F * x) * std::cos(0.11F * y);
            const float dy = -8 * 0.11F * std::sin(0.13F * x) * std::sin(0.11F * y);
            const float length = std::sqrt(1 + dx * dx + dy * dy);
            normals[i] = {-dx / length, -dy / length, 1 / length};
            scalars[i] = 0.5F + z / 20;
        }
    }
    [[nodiscard]] Primitives primitives(std::string layer) const {
        Primitives primitives = Sheet::primitives(std::move(layer));
        primitives.range = {0, 1};
        primitives.value_step = 1.0 / 16384;
        return primitives;
    }
};

TEST(GeometryBatch, ATriangleHasAtMostSixBytes) {
    const Wave wave(180);
    const auto bytes = bytes_of(encode_geometry(std::vector{wave.primitives("a")}, {}, 1.0 / 32)).size();
    const double triangles = static_cast<double>(wave.indices.size()) / 3;
    EXPECT_LE(static_cast<double>(bytes) / triangles, 6);
}

TEST(GeometryBatch, NothingIsOffByMoreThanHalfAStep) {
    const Wave wave(60);
    const DecodedBatch batch = decode(encode_geometry(std::vector{wave.primitives("a")}, {}, step).payloads.at(0));
    ASSERT_EQ(batch.positions.size(), wave.positions.size());
    std::vector<Index> order; // vertices in order of first use, as in the batch
    for (const Index vertex : wave.indices)
        if (std::ranges::find(order, vertex) == order.end()) order.push_back(vertex);
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            EXPECT_LE(std::abs(double{batch.positions[i][axis]} - wave.positions[order[i]][axis]), step / 2);
        EXPECT_NEAR(batch.values[i], wave.scalars[order[i]], 0.5 / 16384 + 1e-7);
    }
}

TEST(GeometryBatch, EqualPositionsAreEqualInAllBatches) {
    const Wave wave(60);
    std::map<std::pair<float, float>, float> heights; // height by (x, y)
    for (const auto& payload : encode_geometry(std::vector{wave.primitives("a")}, {}, step, {}, 300).payloads)
        for (const Vec3f& at : decode(payload).positions) {
            const auto [known, is_new] = heights.try_emplace({at[0], at[1]}, at[2]);
            EXPECT_EQ(known->second, at[2]) << "a crack between two batches";
        }
    EXPECT_EQ(heights.size(), wave.positions.size());
}

TEST(GeometryBatch, NormalsAreOffByAThirdOfADegree) {
    double sum = 0, largest = 0;
    int count = 0;
    for (int i = 0; i < 20'000; ++i) { // evenly distributed over the sphere
        const double z = 1 - (2 * i + 1) / 20'000.0, around = i * 2.399963229728653;
        const double across = std::sqrt(1 - z * z);
        const Vec3f normal{static_cast<float>(across * std::cos(around)), static_cast<float>(across * std::sin(around)),
                           static_cast<float>(z)};
        const Vec3f back = from_octahedral(octahedral(normal));
        const double cosine = double{normal[0]} * back[0] + double{normal[1]} * back[1] + double{normal[2]} * back[2];
        const double degrees = std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
        sum += degrees;
        largest = std::max(largest, degrees);
        ++count;
    }
    EXPECT_LT(sum / count, 0.35);
    EXPECT_LT(largest, 1);
}

TEST(GeometryBatch, ValuesOutsideTheRangeAndNoNumbersComeBack) {
    Wave wave(4);
    wave.scalars[0] = std::numeric_limits<float>::quiet_NaN();
    wave.scalars[1] = 25;
    wave.scalars[2] = -3;
    wave.scalars[3] = std::numeric_limits<float>::infinity();
    const DecodedBatch batch = decode(encode_geometry(std::vector{wave.primitives("a")}, {}, step).payloads.at(0));
    const auto value_of = [&](std::size_t vertex) {
        for (std::size_t i = 0; i < batch.positions.size(); ++i)
            if (std::abs(batch.positions[i][0] - wave.positions[vertex][0]) < 0.5F &&
                std::abs(batch.positions[i][1] - wave.positions[vertex][1]) < 0.5F)
                return batch.values[i];
        return -1.0;
    };
    EXPECT_TRUE(std::isnan(value_of(0)));
    EXPECT_FLOAT_EQ(value_of(1), 25);
    EXPECT_FLOAT_EQ(value_of(2), -3);
    EXPECT_GT(value_of(3), 10'000) << "above every range";
}

TEST(GeometryBatch, DoublesAreAsPreciseAsTheRangeIsNarrow) {
    Wave wave(4);
    const double far = 101325, reach = 0.01;
    std::vector<double> scalars;
    for (const float value : wave.scalars) scalars.push_back(far + reach * std::sin(double{value}));
    Primitives primitives = wave.primitives("a");
    primitives.scalars = scalars;
    primitives.range = {far - reach, far + reach};
    primitives.value_step = 2 * reach / 16384;
    const auto payload = encode_geometry(std::vector{primitives}, {}, step).payloads.at(0);
    const DecodedBatch batch = decode(payload);
    EXPECT_EQ(batch.description["range"], (nlohmann::json{far - reach, far + reach})) << "not rounded to floats";
    EXPECT_EQ(batch.description["values"]["origin"], far - reach);
    const auto spread = std::ranges::minmax(batch.values);
    const auto sent = std::ranges::minmax(scalars);
    EXPECT_GT(sent.max - sent.min, reach / 10) << "less than two floats are apart";
    EXPECT_NEAR(spread.min, sent.min, primitives.value_step / 2);
    EXPECT_NEAR(spread.max, sent.max, primitives.value_step / 2);
}

TEST(GeometryBatch, AValuePerTriangle) {
    const Sheet sheet(30);
    std::vector<float> values(sheet.indices.size() / 3);
    std::iota(values.begin(), values.end(), 0.0F);
    Primitives primitives = sheet.primitives("a");
    primitives.scalars = {};
    primitives.values = values;
    primitives.range = {0, 2048};
    for (const double value_step : {0.0, 1.0 / 8}) {
        primitives.value_step = value_step;
        std::vector<float> got;
        for (const auto& payload : encode_geometry(std::vector{primitives}, {}, step, {}, 100).payloads) {
            const DecodedBatch batch = decode(payload);
            EXPECT_EQ(batch.description["values"]["of"], "triangles");
            got.insert(got.end(), batch.values.begin(), batch.values.end());
        }
        EXPECT_EQ(got, values) << "in the order of the triangles";
    }
    primitives.values = primitives.values.subview(0, 1);
    EXPECT_THROW(static_cast<void>(encode_geometry(std::vector{primitives}, {}, step)), Error);
}

TEST(GeometryBatch, WhatTheReceiverHasIsNotSentAgain) {
    const Wave wave(60);
    GeometryClient client;
    const auto decode_all = [&](const EncodedGeometry& encoded) {
        std::vector<Vec3f> positions;
        for (const auto& payload : encoded.payloads) {
            const DecodedBatch batch = client.decode(payload);
            positions.insert(positions.end(), batch.positions.begin(), batch.positions.end());
        }
        return positions;
    };
    Primitives kept = wave.primitives("kept"), changed = wave.primitives("changed");
    const auto first = encode_geometry(std::vector{kept, changed}, {}, step);
    const auto before = decode_all(first);

    const HeldArrays held{7, first.ids};
    kept.color = {1, 0, 0, 1};
    Wave moved(60);
    for (Vec3f& at : moved.positions) at[0] += 1;
    const auto second = encode_geometry(std::vector{kept, moved.primitives("changed")}, {}, step, held);
    EXPECT_LT(second.payloads[0].size(), 1000U) << "a description";
    EXPECT_GT(second.payloads[1].size(), 10'000U);
    const auto after = decode_all(second);
    EXPECT_TRUE(std::equal(before.begin(), before.begin() + 3721, after.begin()));
    EXPECT_NE(before, after);
    const DecodedBatch described = GeometryClient(client).decode(second.payloads[0]);
    EXPECT_EQ(described.description["color"], nlohmann::json({1, 0, 0, 1}));
    EXPECT_EQ(described.description["base"], 7);

    Wave hotter(60);
    for (float& value : hotter.scalars) value += 0.25F;
    const auto third = encode_geometry(std::vector{hotter.primitives("kept")}, {}, step, held);
    EXPECT_LT(bytes_of(third).size(), bytes_of(first).size() / 4) << "values alone";
    EXPECT_TRUE(encode_geometry(std::vector{wave.primitives("kept")}, {}, step / 2, held).payloads[0].size() > 10'000U)
        << "another grid is another mesh";
}

TEST(GeometryBatch, TheGridIsAPowerOfTwoThatFloatsResolve) {
    EXPECT_EQ(grid_step(0.3, 10), 0.25);
    EXPECT_EQ(grid_step(0.25, 10), 0.25);
    EXPECT_GE(grid_step(1e-12, 10), 10 * std::ldexp(1.0, -24));
    EXPECT_LE(grid_step(1e-12, 10), 10 * std::ldexp(1.0, -23));
    EXPECT_GT(grid_step(0, 0), 0);
}

TEST(GeometryBatch, VerticesAreSharedInsideABatch) {
    const Sheet sheet(40);
    const auto payloads = encode_geometry(std::vector{sheet.primitives("a")}, {}, step).payloads;
    EXPECT_EQ(decode(payloads.at(0)).positions.size(), sheet.positions.size());
}

TEST(GeometryBatch, LinesWithoutNormalsOrScalars) {
    const std::vector<Vec3f> positions{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}};
    const std::vector<Index> indices{0, 1, 1, 2};
    Primitives primitives;
    primitives.layer = "outline";
    primitives.positions = positions;
    primitives.indices = indices;
    primitives.lines = true;
    primitives.lit = false;
    const DecodedBatch batch = decode(encode_geometry(std::vector{primitives}, {}, step).payloads.at(0));
    EXPECT_EQ(batch.description["kind"], "lines");
    EXPECT_EQ(batch.description["lit"], false);
    EXPECT_EQ(batch.positions, positions);
    EXPECT_EQ(batch.indices, indices);
}

TEST(GeometryBatch, NothingIsOneMessageThatSaysSo) {
    const Sheet sheet(2);
    Primitives empty = sheet.primitives("gone");
    empty.indices = {};
    for (const auto& all : {std::vector<Primitives>{}, std::vector{empty}}) {
        const auto payloads = encode_geometry(all, {}, step).payloads;
        ASSERT_EQ(payloads.size(), 1U);
        const DecodedBatch batch = decode(payloads[0]);
        EXPECT_EQ(batch.description["batches"], 0);
        EXPECT_EQ(batch.description["vertices"], 0);
    }
}

TEST(GeometryBatch, ArraysThatDoNotFitAreRefused) {
    const Sheet sheet(2);
    const std::vector<Index> beyond{0, 1, 9};
    struct Row {
        const char* name;
        void (*spoil)(Primitives&, const std::vector<Index>&);
    };
    for (const Row& row :
         {Row{"normals", [](Primitives&m, const std::vector<Index>&) { m.normals = m.normals.first(1); }},
          Row{"scalars", [](Primitives&m, const std::vector<Index>&) { m.scalars = m.scalars.subview(0, 1); }},
          Row{"corners", [](Primitives&m, const std::vector<Index>&) { m.indices = m.indices.first(4); }},
          Row{"beyond", [](Primitives&m, const std::vector<Index>&b) { m.indices = b; }}}) {
        Primitives primitives = sheet.primitives("a");
        row.spoil(primitives, beyond);
        EXPECT_THAT([&] { static_cast<void>(encode_geometry(std::vector{primitives}, {}, step)); },
                    testing::ThrowsMessage<Error>(testing::HasSubstr("layer 'a'")))
            << row.name;
    }
}

TEST(GeometryBatch, LinesPointsAndClipPlanesAreDescribed) {
    const Sheet sheet(2);
    const std::vector<std::array<float, 4>> planes{{1, 0, 0, 0.5F}, {0, -0.25F, 1, -2}};
    const std::vector<Index> all{0, 1, 2, 3, 4, 5, 6, 7};
    Primitives points = sheet.primitives("p");
    points.normals = {};
    points.indices = all;
    points.points = true;
    points.line_width = 7.5F;
    points.clip = planes;
    Primitives lines = points;
    lines.points = false;
    lines.lines = true;
    lines.clip = {};
    const auto payloads = encode_geometry(std::vector{points, lines, sheet.primitives("t")}, {1, 2, 3}, step).payloads;
    ASSERT_EQ(payloads.size(), 3U);
    const DecodedBatch first = decode(payloads[0]);
    EXPECT_EQ(first.description["kind"], "points");
    EXPECT_EQ(first.description["width"], 7.5);
    EXPECT_EQ(first.description["clip"], nlohmann::json::parse("[[1, 0, 0, 0.5], [0, -0.25, 1, -2]]"));
    EXPECT_EQ(first.indices, all);
    EXPECT_EQ(decode(payloads[1]).description["kind"], "lines");
    EXPECT_FALSE(decode(payloads[1]).description.contains("clip"));
    EXPECT_FALSE(decode(payloads[2]).description.contains("width"));
    EXPECT_EQ(encode_geometry(std::vector{points}, {}, step, {}, 3).payloads.size(), 3U)
        << "a point may stand alone in a batch";
}

} // namespace
} // namespace server::wire
