// Gradients of linear fields on stretched cells, as in boundary layers.
#include "fields/cell_gradient.hpp"
#include "oracle/kernel_mesh.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace ciel::test {

using namespace ciel::detail;

namespace {

using Axes = std::array<Point, 3>; // orthonormal

// Angles for which no component of the axes is zero.
Axes turned() {
    const double a = 0.6435, b = 1.1071, c = 0.2914;
    const double ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b), cc = std::cos(c),
                 sc = std::sin(c);
    return {{{ca * cb, sa * cb, -sb},
             {ca * sb * sc - sa * cc, sa * sb * sc + ca * cc, cb * sc},
             {ca * sb * cc + sa * sc, sa * sb * cc - ca * sc, cb * cc}}};
}

double along(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Stretch {
    const char* name;
    Point scale(double by) const { return needle ? Point{1, 1 / by, 1 / by} : Point{1, 1, 1 / by}; }
    bool needle;
    friend std::ostream& operator<<(std::ostream& out, const Stretch& stretch) { return out << stretch.name; }
};

Point placed(const Point& p, const Point& scale, const Axes& axes) {
    Point out{};
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < 3; ++k) out[k] += p[axis] * scale[axis] * axes[axis][k];
    return out;
}

class StretchedCell : public testing::TestWithParam<Stretch> {
protected:
    // Uses positions in double, so only the solver's error remains. The slope along each axis of the cell has an error
    // below 1e-6, along short and long axes.
    template <const StandardShape& shape>
    void expect_exact(const std::array<Point, shape.corners>& corners, double unit_volume) {
        const Axes axes = turned();
        for (const double by : {1.0, 1e3, 1e4, 1e5, 1e6, 1e7}) {
            const Point scale = GetParam().scale(by);
            const Point slope{1.5, -0.75, 2}; // along the cell's axes
            std::array<Sample, shape.corners> samples;
            for (std::size_t c = 0; c < shape.corners; ++c) {
                const Point p = placed(corners[c], scale, axes);
                samples[c] = {p[0], p[1], p[2], 7};
                for (std::size_t axis = 0; axis < 3; ++axis)
                    samples[c].value += slope[axis] * corners[c][axis] * scale[axis];
            }
            const CellGradient made = standard_gradient<shape>(samples);
            const Point gradient{made.gradient[0], made.gradient[1], made.gradient[2]};
            // Positions and values are rounded to 53 bits, the gradient to 24.
            const double tolerance = 1e-6 + 1e-14 * by;
            for (std::size_t axis = 0; axis < 3; ++axis)
                EXPECT_NEAR(along(gradient, axes[axis]), slope[axis], tolerance) << by << " axis " << axis;
            const double volume = unit_volume * scale[0] * scale[1] * scale[2];
            EXPECT_NEAR(made.volume, volume, 1e-6 * volume) << by;
        }
    }
};

TEST_P(StretchedCell, OfEachStandardType) {
    const Point o{-0.5, -0.5, -0.5}, x{0.5, -0.5, -0.5}, xy{0.5, 0.5, -0.5}, y{-0.5, 0.5, -0.5}, z{-0.5, -0.5, 0.5},
        xz{0.5, -0.5, 0.5}, xyz{0.5, 0.5, 0.5}, yz{-0.5, 0.5, 0.5};
    expect_exact<tetrahedron_shape>({o, x, y, z}, 1.0 / 6);
    expect_exact<hexahedron_shape>({o, x, xy, y, z, xz, xyz, yz}, 1);
    expect_exact<wedge_shape>({o, y, x, z, yz, xz}, 0.5);
    expect_exact<pyramid_shape>({o, x, xy, y, {0, 0, 0.5}}, 1.0 / 3);
}

// A cell without volume has no gradient, at any place and orientation.
TEST(StretchedCells, FlatOnesDoNotCount) {
    for (const Point& far : {Point{0, 0, 0}, Point{1000, -3000, 700}, Point{0.1F, 0.7F, 0.3F}})
        for (const double tilt : {0.0, 0.25, 1.0}) {
            const auto at = [&](double x, double y) {
                const float px = static_cast<float>(far[0] + x), py = static_cast<float>(far[1] + y);
                return Sample{px, py, far[2] + tilt * (double{px} - far[0]), x + 2 * y};
            };
            std::array<Sample, 4> tetrahedron{at(0, 0), at(1, 0), at(0, 1), at(1, 1)};
            EXPECT_EQ(standard_gradient<tetrahedron_shape>(tetrahedron).volume, 0);
            std::array<Sample, 6> wedge{at(0, 0), at(1, 0), at(0, 1), at(0, 0.5), at(1, 0.5), at(0.5, 0.25)};
            EXPECT_EQ(standard_gradient<wedge_shape>(wedge).volume, 0);
        }
}

class StretchedMesh : public testing::TestWithParam<std::tuple<Stretch, NamedMesh>> {};

// Positions and values in float32. The tolerance is half a unit in the last place of the values, divided by the
// thinnest cell's thickness.
TEST_P(StretchedMesh, HasTheGradientOfALinearField) {
    const auto& [stretch, named] = GetParam();
    const Axes axes = turned();
    for (const double by : {1e3, 1e4, 1e5, 1e6}) {
        Polyhedra input = named.make();
        const Point scale = stretch.scale(by);
        for (Id v = 0; v < input.vertex_count(); ++v) {
            const Point p = placed(input.position(v), scale, axes);
            for (std::size_t k = 0; k < 3; ++k) input.positions[3 * v + k] = static_cast<float>(p[k]);
        }
        const KernelMesh mesh(input);
        for (const std::size_t axis : {0U, 2U}) { // along the longest and along the shortest edges
            std::vector<float> values(input.vertex_count());
            double largest = 0;
            for (Id v = 0; v < input.vertex_count(); ++v) {
                values[v] = static_cast<float>(along(input.position(v), axes[axis]));
                largest = std::max(largest, std::abs(double{values[v]}));
            }
            const std::vector<Vec3f> gradients = vertex_gradients(mesh.topology, mesh.mesh(), mesh.stored(values));
            const double bound = 1e-5 + 40 * largest * 6e-8 * by;
            double worst = 0, worst_along = 0;
            for (const Vec3f& g : gradients) {
                const Point gradient{g[0], g[1], g[2]};
                Point error{};
                for (std::size_t k = 0; k < 3; ++k) error[k] = gradient[k] - axes[axis][k];
                worst = std::max(worst, std::sqrt(along(error, error)));
                worst_along = std::max(worst_along, std::abs(along(error, axes[0])));
            }
            EXPECT_LE(worst, bound) << by << " axis " << axis;
            EXPECT_LE(worst_along, 1e-2 + bound / by * 100) << by << " axis " << axis;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, StretchedCell, testing::Values(Stretch{"needle", true}, Stretch{"pancake", false}),
                         [](const auto& test) { return std::string(test.param.name); });

std::vector<NamedMesh> meshes() {
    std::vector<NamedMesh> out;
    std::ranges::copy_if(all_meshes(), std::back_inserter(out), [](const NamedMesh& mesh) {
        for (const char* wanted :
             {"tetrahedra", "hexahedra", "wedges", "pyramids", "zoo", "voronoi", "hexagonal_prisms"})
            if (mesh.name == wanted) return true;
        return false;
    });
    return out;
}

INSTANTIATE_TEST_SUITE_P(All, StretchedMesh,
                         testing::Combine(testing::Values(Stretch{"needle", true}, Stretch{"pancake", false}),
                                          testing::ValuesIn(meshes())),
                         [](const auto& test) {
                             return std::get<0>(test.param).name + std::string("_") + std::get<1>(test.param).name;
                         });

} // namespace
} // namespace ciel::test
