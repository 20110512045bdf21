// Slice polygons that are drawn without entry and exit tests of their rays must not meet the mesh's boundary.
#include "render/volume/boundary_of_slabs.hpp"
#include "render/volume/inner_polygons.hpp"
#include "scenes.hpp"
#include "support/meshes.hpp"
#include "volume_compare.hpp"

#include <gmock/gmock.h>
#include <random>

namespace server::render {
using namespace ciel;
namespace {

using test::Box;

constexpr std::size_t slab_count = 60;

double ramp(const Vec3d& p) { return 0.5 * p[0] + 0.2 * p[1] + 0.3 * p[2]; }

// 8 x 8 x 8 cubes without a 2 x 2 column of them.
test::Polyhedra with_a_hole() {
    return test::keep_cells(test::hexahedra(Box{{8, 8, 8}, 0, 1, 0.125}), [](test::Id cell) {
        const auto x = cell % 8, y = cell / 8 % 8;
        return x < 3 || x > 4 || y < 3 || y > 4;
    });
}

Vec3d vector_of(const Vec3f& v) { return {v[0], v[1], v[2]}; }
double dot_of(const Vec3d& a, const Vec3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

bool meets(const Vec3d& from, const Vec3d& way, const std::array<Vec3d, 3>& triangle) {
    const Vec3d ab = plus(triangle[1], triangle[0], -1), ac = plus(triangle[2], triangle[0], -1);
    const Vec3d across = cross_of(way, ac), start = plus(from, triangle[0], -1), turned = cross_of(start, ab);
    const double volume = dot_of(ab, across);
    if (volume == 0) return false;
    const double u = dot_of(start, across) / volume, v = dot_of(way, turned) / volume;
    const double t = dot_of(ac, turned) / volume;
    return u >= 0 && v >= 0 && u + v <= 1 && t >= -1 && t <= 1;
}

const color::SlabVertex& corner(const SortedSlice& sorted, std::size_t i) {
    const std::size_t own = sorted.slice->vertices.size(), at = sorted.triangles[i];
    return at < own ? sorted.slice->vertices[at] : sorted.more[at - own];
}

double area(const Vec3f& a, const Vec3f& b, const Vec3f& c) {
    const Vec3d size = cross_of(plus(vector_of(b), vector_of(a), -1), plus(vector_of(c), vector_of(a), -1));
    return std::sqrt(dot_of(size, size)) / 2;
}

struct Case {
    const char* name;
    Vec3d normal;
    std::size_t stride;

    friend std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.name; }
};

class InnerPolygons : public testing::TestWithParam<Case> {
protected:
    InnerPolygons() : volume(scene.volume(unit_of(GetParam().normal), slab_count)) {
        volume.stride = GetParam().stride;
        thickness = volume.thickness * static_cast<double>(volume.stride);
        const auto lists = boundary_of_slabs(volume);
        slices = sort_slices(volume, lists);
    }

    [[nodiscard]] bool meets_boundary(const Vec3d& from, const Vec3d& way) const {
        const color::SlabTriangles& mesh = *volume.boundary;
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
            std::array<Vec3d, 3> triangle{};
            for (std::size_t k = 0; k < 3; ++k) triangle[k] = vector_of(mesh.vertices[mesh.triangles[i + k]].position);
            if (meets(from, way, triangle)) return true;
        }
        return false;
    }

    VolumeScene scene{with_a_hole(), ramp};
    Volume volume;
    double thickness = 0;
    std::vector<SortedSlice> slices;
};

const std::vector<Case> cases{{"along_x", {1, 0, 0}, 1},
                              {"along_z", {0, 0, 1}, 1},
                              {"slanted", {0.3, -0.5, 0.8}, 1},
                              {"slanted_otherwise", {-0.6, 0.2, 0.4}, 1},
                              {"thick_slabs", {0, 1, 0}, 3}};
INSTANTIATE_TEST_SUITE_P(Cases, InnerPolygons, testing::ValuesIn(cases), testing::PrintToStringParamName());

TEST_P(InnerPolygons, AreMetByNoRayThatEntersOrLeavesTheMeshInTheirSlab) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    const Vec3d normal = volume.normal;
    const Vec3d side = unit_of(cross_of(normal, {0.3, 0.5, 0.81})), other = cross_of(normal, side);
    std::size_t asked = 0, met = 0;
    for (const SortedSlice& sorted : slices)
        for (std::size_t i = sorted.outer; i < sorted.triangles.size(); i += 3) {
            const Vec3d a = vector_of(corner(sorted, i).position);
            const double u = (any(random) + 1) / 2, v = (any(random) + 1) / 2 * (1 - u);
            Vec3d point = plus(a, plus(vector_of(corner(sorted, i + 1).position), a, -1), u);
            point = plus(point, plus(vector_of(corner(sorted, i + 2).position), a, -1), v);
            const double angle = std::acos(-1.0) * any(random), far = widest_inner * (1 - std::pow(any(random), 4));
            Vec3d way = plus(plus(normal, side, far * std::cos(angle)), other, far * std::sin(angle));
            for (double& part : way) part *= thickness / 2;
            ++asked;
            if (meets_boundary(point, way)) ++met;
        }
    EXPECT_GT(asked, 100U);
    EXPECT_EQ(met, 0U) << "of " << asked;
}

TEST_P(InnerPolygons, AndTheOthersAreTheWholeSlice) {
    double inner = 0, all = 0;
    for (const SortedSlice& sorted : slices) {
        ASSERT_NE(sorted.slice, nullptr);
        double sum = 0, expected = 0;
        for (std::size_t i = 0; i < sorted.triangles.size(); i += 3) {
            const double size =
                area(corner(sorted, i).position, corner(sorted, i + 1).position, corner(sorted, i + 2).position);
            sum += size;
            if (i >= sorted.outer) inner += size;
            // The limits belong to the polygon, so the values at all its corners are inside them.
            const auto [low, high] = corner(sorted, i).limits;
            for (std::size_t k = 0; k < 3; ++k)
                EXPECT_THAT(corner(sorted, i + k).value,
                            testing::AllOf(testing::Ge(low - 1e-6F), testing::Le(high + 1e-6F)));
        }
        const auto& [vertices, triangles] = *sorted.slice;
        for (std::size_t i = 0; i < triangles.size(); i += 3)
            expected += area(vertices[triangles[i]].position, vertices[triangles[i + 1]].position,
                             vertices[triangles[i + 2]].position);
        EXPECT_NEAR(sum, expected, 1e-5);
        all += expected;
    }
    EXPECT_GT(inner, 0.15 * all);
}

// Any surface in the frame turns the fast program for inner polygons off. This one is degenerate and covers no pixel.
TEST(InnerPolygonsOfAPicture, LookAsTheOthersDo) {
    VolumeScene scene(with_a_hole(), ramp);
    Shape nowhere;
    nowhere.positions = {{0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}, {0.5F, 0.5F, 0.5F}};
    nowhere.indices = {0, 1, 2};
    for (const View& view : views)
        for (const Vec3d& normal : {nearest_axis(view.from), unit_of(view.from)}) {
            Frame frame = frame_of(view);
            frame.volumes = {scene.volume(normal, slab_count)};
            frame.volumes[0].shaded = true;
            frame.volumes[0].opacity_points = {{0, 0.2}, {1, 0.9}};
            Image inner, others;
            renderer().draw(frame, inner);
            frame.primitives = {nowhere.primitives()};
            renderer().draw(frame, others);
            int most = 0;
            for (std::size_t i = 0; i < inner.rgb.size(); ++i)
                most = std::max(most, std::abs(inner.rgb[i] - others.rgb[i]));
            EXPECT_LE(most, 1) << view.name << ", slabs along " << testing::PrintToString(normal);
        }
}

} // namespace
} // namespace server::render
