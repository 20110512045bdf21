// Areas, volumes, orientation and normals of plane cuts through a box, against closed forms.
#include "oracle/kernel_mesh.hpp"
#include "support/fields.hpp"
#include "support/meshes.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace ciel::test {
namespace {

double dot(const Vec3d& a, const Vec3d& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Vec3d unit(const Vec3d& v) {
    const double length = std::sqrt(dot(v, v));
    return {v[0] / length, v[1] / length, v[2] / length};
}

Vec3d total_area(const Surface& surface) {
    Vec3d sum{};
    for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p) {
        const Vec3d area = vector_area(surface.positions, polygon(surface, p));
        for (std::size_t d = 0; d < 3; ++d) sum[d] += area[d];
    }
    return sum;
}

// Volume between the surface and the origin: a third of the sum of (position . area) over triangles.
double cone_volume(const Surface& surface) {
    double sum = 0;
    for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p) {
        const auto corners = polygon(surface, p);
        const Vec3f& corner = surface.positions[corners[0]];
        sum += dot(vector_area(surface.positions, corners), {corner[0], corner[1], corner[2]}) / 3;
    }
    return sum;
}

// Sum over the box's corners by inclusion and exclusion, for gradients with positive components.
double corner_sum(const Vec3d& size, const Vec3d& gradient, double nu, int power) {
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double rest = nu;
        for (int d = 0; d < 3; ++d) rest -= (corner >> d & 1) * gradient[d] * size[d];
        sum += (std::popcount(static_cast<unsigned>(corner)) % 2 ? -1 : 1) * std::pow(std::max(0.0, rest), power);
    }
    return sum / (gradient[0] * gradient[1] * gradient[2]);
}

// Volume of the part of the box [0, size] where gradient . x < nu.
double volume_below(const Vec3d& size, const Vec3d& gradient, double nu) {
    return corner_sum(size, gradient, nu, 3) / 6;
}

// Area of the plane section: the derivative of the volume with respect to the distance along the gradient.
double section_area(const Vec3d& size, const Vec3d& gradient, double nu) {
    return corner_sum(size, gradient, nu, 2) / 2 * std::sqrt(dot(gradient, gradient));
}

struct FilledBox {
    const char* name;
    Polyhedra (*make)();
    Vec3d size;

    friend std::ostream& operator<<(std::ostream& out, const FilledBox& box) { return out << box.name; }
};

class PlaneThroughABox : public testing::TestWithParam<FilledBox> {
protected:
    Polyhedra input = GetParam().make();
    const KernelMesh mesh{input, {32}};
    const Vec3d size = GetParam().size;
};

TEST_P(PlaneThroughABox, HasTheAreaAndTheVolumeOfTheClosedForm) {
    for (const Vec3d& gradient : {Vec3d{1, 1, 1}, Vec3d{1, 0.5, 0.25}, Vec3d{0.3, 2, 0.7}}) {
        const std::vector<float> values = linear_field(input, {gradient});
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        const double top = dot(gradient, size);
        for (double share : {0.02, 0.1, 0.25, 1.0 / 3, 0.5, 0.71, 0.9}) {
            SCOPED_TRACE(share);
            Surface surface;
            ASSERT_TRUE(query.extract(share * top, false, surface));
            const Vec3d area = total_area(surface), direction = unit(gradient);
            const double expected = section_area(size, gradient, share * top);
            EXPECT_NEAR(dot(area, direction), expected, 2e-5 * expected + 1e-7);
            for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(area[d], expected * direction[d], 1e-4 * expected);
            double unsigned_area = 0;
            for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p) {
                const Vec3d piece = vector_area(surface.positions, polygon(surface, p));
                unsigned_area += std::sqrt(dot(piece, piece));
                EXPECT_GT(dot(piece, direction), -1e-6 * expected); // every polygon faces the higher values
            }
            EXPECT_NEAR(unsigned_area, expected, 1e-4 * expected);
            // While the plane meets only the three coordinate planes, the cone volume is the volume below the plane.
            const double nu = share * top;
            if (nu < gradient[0] * size[0] && nu < gradient[1] * size[1] && nu < gradient[2] * size[2]) {
                const double below = volume_below(size, gradient, nu);
                EXPECT_NEAR(cone_volume(surface), below, 1e-4 * below);
            }
        }
    }
}

// Integrates section areas over nu. Valid for every nu, also where the plane meets the other sides of the box.
TEST_P(PlaneThroughABox, SectionsAddUpToTheVolume) {
    const Vec3d gradient{1, 0.5, 0.25};
    const std::vector<float> values = linear_field(input, {gradient});
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query();
    query.set_field(field);
    std::vector<double> nus;
    const double top = dot(gradient, size), step = top / 64;
    for (int i = 0; i < 64; ++i) nus.push_back((i + 0.5) * step);
    double volume = 0;
    ASSERT_TRUE(extract_series(query, nus, false, [&](double, Surface&& surface) {
        volume += dot(total_area(surface), unit(gradient)) * step / std::sqrt(dot(gradient, gradient));
    }));
    EXPECT_NEAR(volume, size[0] * size[1] * size[2], 1e-3 * volume);
}

TEST_P(PlaneThroughABox, SlicesAcrossAnAxisCoverTheBoxExactlyOnce) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Vec3d normal{};
        normal[axis] = 1;
        const std::vector<float> distance = plane_distance(mesh.mesh(), {}, normal);
        const Field field = make_field(mesh.topology, distance);
        Query query = mesh.query();
        query.set_field(field);
        const double expected = size[(axis + 1) % 3] * size[(axis + 2) % 3];
        // Several values coincide with layers of vertices.
        for (double share : {0.0, 0.1, 0.25, 1.0 / 3, 0.5, 0.75, 1.0}) {
            Surface surface;
            ASSERT_TRUE(query.extract(share * size[axis], false, surface));
            if (share > 0)
                EXPECT_NEAR(total_area(surface)[axis], expected, 1e-5 * expected) << axis << " " << share;
            else
                EXPECT_TRUE(surface.points.empty()); // no vertex is lower
        }
    }
}

TEST_P(PlaneThroughABox, NormalsAreTheGradientOfALinearField) {
    const Vec3d gradient{-0.5, 1, 2};
    const std::vector<float> values = linear_field(input, {gradient, 1});
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query();
    query.set_field(field);
    std::size_t normals = 0;
    for (double nu : walk_through(values, 5, 111)) {
        Surface surface;
        ASSERT_TRUE(query.extract(nu, true, surface));
        ASSERT_EQ(surface.normals.size(), surface.points.size());
        normals += surface.normals.size();
        for (const Vec3f& normal : surface.normals) {
            for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(normal[d], unit(gradient)[d], 1e-3) << nu;
        }
    }
    EXPECT_GT(normals, 100U);
}

TEST_P(PlaneThroughABox, InterpolationOfALinearFieldIsTheFieldAtThePosition) {
    const std::vector<float> values = bumps_field(input, 112);
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0.5, false, surface));
    ASSERT_GT(surface.points.size(), 10U);
    ASSERT_EQ(surface.positions.size(), surface.points.size());
    const LinearField first{{1, 2, 3}, -1}, second{{-2, 0, 1}, 5};
    const std::vector<float> a = mesh.stored(linear_field(input, first)), b = mesh.stored(linear_field(input, second));
    std::vector<float> both, result(2 * surface.points.size());
    for (std::size_t v = 0; v < a.size(); ++v) both.insert(both.end(), {a[v], b[v]});
    interpolate(surface.points, both, 2, result);
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        const Vec3f& p = surface.positions[i];
        EXPECT_NEAR(result[2 * i], first.at({p[0], p[1], p[2]}), 1e-4);
        EXPECT_NEAR(result[2 * i + 1], second.at({p[0], p[1], p[2]}), 1e-4);
    }
}

TEST_P(PlaneThroughABox, TrianglesKeepTheAreaOfTheirPolygons) {
    for (const NamedField& named : all_fields()) {
        const std::vector<float> values = named.make(input);
        const Field field = make_field(mesh.topology, mesh.stored(values));
        Query query = mesh.query();
        query.set_field(field);
        for (double nu : walk_through(values, 4, 113)) {
            Surface surface;
            ASSERT_TRUE(query.extract(nu, false, surface));
            const std::vector<Index> triangles = triangulate(surface);
            ASSERT_EQ(triangles.size() % 3, 0U);
            Vec3d sum{};
            double unsigned_area = 0;
            for (std::size_t t = 0; t < triangles.size(); t += 3) {
                const auto corners = std::span(triangles).subspan(t, 3);
                for (Index v : corners) ASSERT_LT(v, surface.points.size());
                const Vec3d area = vector_area(surface.positions, corners);
                EXPECT_GT(dot(area, area), 0);
                for (std::size_t d = 0; d < 3; ++d) sum[d] += area[d];
                unsigned_area += std::sqrt(dot(area, area));
            }
            const Vec3d expected = total_area(surface);
            for (std::size_t d = 0; d < 3; ++d) {
                EXPECT_NEAR(sum[d], expected[d], 1e-5 * unsigned_area + 1e-6) << named.name << " at " << nu;
            }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, PlaneThroughABox,
                         testing::Values(FilledBox{"hexahedra",
                                                   [] {
                                                       return hexahedra({{3, 4, 5}});
                                                   },
                                                   {3, 4, 5}},
                                         FilledBox{"hexahedra_jittered",
                                                   [] {
                                                       return hexahedra({{3, 4, 5}, 0.2, 1});
                                                   },
                                                   {3, 4, 5}},
                                         FilledBox{"tetrahedra_jittered",
                                                   [] {
                                                       return tetrahedra({{4, 3, 3}, 0.15, 2});
                                                   },
                                                   {4, 3, 3}},
                                         FilledBox{"five_tetrahedra",
                                                   [] {
                                                       return five_tetrahedra({{4, 4, 4}});
                                                   },
                                                   {4, 4, 4}},
                                         FilledBox{"wedges_jittered",
                                                   [] {
                                                       return wedges({{4, 3, 3}, 0.15, 3});
                                                   },
                                                   {4, 3, 3}},
                                         FilledBox{"pyramids_jittered",
                                                   [] {
                                                       return pyramids({{3, 4, 3}, 0.15, 4});
                                                   },
                                                   {3, 4, 3}},
                                         FilledBox{"zoo",
                                                   [] {
                                                       return zoo({{4, 4, 4}, 0, 5});
                                                   },
                                                   {4, 4, 4}},
                                         FilledBox{"zoo_jittered",
                                                   [] {
                                                       return zoo({{4, 4, 4}, 0.1, 6});
                                                   },
                                                   {4, 4, 4}},
                                         FilledBox{"hanging_nodes",
                                                   [] {
                                                       return hanging_nodes({{4, 4, 4}, 0, 7});
                                                   },
                                                   {4, 4, 4}},
                                         FilledBox{"agglomerated",
                                                   [] {
                                                       return agglomerated(hexahedra({{4, 4, 4}}), 4, 8);
                                                   },
                                                   {4, 4, 4}},
                                         FilledBox{"voronoi", [] { return voronoi(200, 9); }, {1, 1, 1}}),
                         [](const auto& test) { return std::string(test.param.name); });

// The polygon of a tetrahedron is planar, so its orientation is well defined.
TEST(Orientation, PolygonsOfTetrahedraFaceTheHigherValues) {
    const Polyhedra input = tetrahedra({{4, 4, 4}, 0.15, 114});
    const KernelMesh mesh(input);
    const std::vector<float> values = random_field(input.vertex_count(), 115);
    const Field field = make_field(mesh.topology, mesh.stored(values));
    Query query = mesh.query();
    query.set_field(field);
    Surface surface;
    ASSERT_TRUE(query.extract(0.5, false, surface));
    ASSERT_GT(surface.polygon_cell.size(), 100U);
    for (std::size_t p = 0; p < surface.polygon_cell.size(); ++p) {
        const Vec3d area = vector_area(surface.positions, polygon(surface, p));
        for (Index corner : polygon(surface, p)) {
            const auto [a, b, t] = surface.points[corner];
            const bool rises = field.values()[b] >= 0.5;
            Vec3d along;
            for (std::size_t d = 0; d < 3; ++d) {
                along[d] = (rises ? 1.0 : -1.0) *
                           (double(mesh.mesh().positions[3 * b + d]) - mesh.mesh().positions[3 * a + d]);
            }
            EXPECT_GT(dot(area, along), -1e-9);
        }
    }
}

} // namespace
} // namespace ciel::test
