// The kernel's public interface: the caller's arrays in, surfaces with the caller's ids out.
#include "ciel/contour.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numeric>
#include <optional>
#include <set>

namespace ciel {
namespace {

// The cube [0, n]^3 in n x n x n unit cells, in layers from the top. `step_of_ids`: spreads the ids of neighboring
// points, as in real files; 1: point ids in order.
struct Box {
    static constexpr int n = 5, row = n + 1;
    std::vector<double> points;
    std::vector<std::uint8_t> types;
    std::vector<std::int64_t> offsets{0}, connectivity;

    explicit Box(std::size_t step_of_ids = 1) {
        const std::size_t count = row * row * row;
        points.resize(3 * count);
        std::vector<std::int64_t> id(count);
        for (std::size_t i = 0; i < count; ++i) id[i] = static_cast<std::int64_t>(i * step_of_ids % count);
        const auto at = [](int x, int y, int z) { return static_cast<std::size_t>((z * row + y) * row + x); };
        for (int z = 0; z < row; ++z)
            for (int y = 0; y < row; ++y)
                for (int x = 0; x < row; ++x) {
                    double* to = &points[3 * static_cast<std::size_t>(id[at(x, y, z)])];
                    to[0] = x, to[1] = y, to[2] = z;
                }
        for (int z = n; z-- > 0;)
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    for (const int up : {0, 1})
                        for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
                            connectivity.push_back(id[at(x + dx, y + dy, z + up)]);
                    types.push_back(12);
                    offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
                }
    }
    [[nodiscard]] VtkCells cells() const { return {types, offsets, connectivity}; }
    [[nodiscard]] Mesh mesh() const { return Mesh::from_cells({points, 3}, cells()); }
    [[nodiscard]] std::size_t point_count() const { return points.size() / 3; }
    // Distance of each point from (2.4, 2.5, 2.6), near the center.
    [[nodiscard]] std::vector<double> radius() const {
        std::vector<double> values;
        for (std::size_t i = 0; i < points.size(); i += 3)
            values.push_back(std::hypot(points[i] - 2.4, points[i + 1] - 2.5, points[i + 2] - 2.6));
        return values;
    }
    // Writes the same cells as polyhedra, each with the list of its faces.
    void faces_of_cells(std::vector<std::uint64_t>& cell_offset, std::vector<std::uint64_t>& face_offset,
                        std::vector<Index>& face_vertex) const {
        cell_offset = {0}, face_offset = {0};
        face_vertex.clear();
        for (std::size_t c = 0; c < types.size(); ++c) {
            std::vector<Index> corners(connectivity.begin() + static_cast<std::ptrdiff_t>(8 * c),
                                       connectivity.begin() + static_cast<std::ptrdiff_t>(8 * c + 8));
            append_standard_faces(CellType::hexahedron, corners, face_offset, face_vertex);
            cell_offset.push_back(face_offset.size() - 1);
        }
    }
};

// Surface independent of the order of points and polygons: for each polygon, its cell and its sorted world positions.
using Polygons = std::multiset<std::pair<Index, std::vector<std::array<int, 3>>>>;
Polygons polygons_of(const Mesh& mesh, const Surface& surface) {
    Polygons out;
    for (std::size_t i = 0; i < surface.polygon_cell.size(); ++i) {
        std::vector<std::array<int, 3>> corners;
        for (Index k = surface.polygon_offset[i]; k < surface.polygon_offset[i + 1]; ++k) {
            const Vec3f& at = surface.positions[surface.polygon_vertex[k]];
            std::array<int, 3> rounded{};
            for (std::size_t a = 0; a < 3; ++a)
                rounded[a] = static_cast<int>(std::lround(1e4 * (mesh.stored().surface_origin[a] + double{at[a]})));
            corners.push_back(rounded);
        }
        std::ranges::sort(corners);
        out.emplace(surface.polygon_cell[i], corners);
    }
    return out;
}

TEST(Mesh, IdsInResultsAreTheCallers) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    const std::vector<double> radius = box.radius();
    const Surface surface = contour(mesh, radius, 1.7);
    ASSERT_FALSE(surface.polygon_cell.empty());
    for (const EdgePoint& point : surface.points) {
        const auto [low, high] = std::minmax(radius[point.a], radius[point.b]);
        EXPECT_LT(low, 1.7);
        EXPECT_GE(high, 1.7F);
    }
    for (const Index cell : surface.polygon_cell) {
        double low = INFINITY, high = -INFINITY;
        for (std::size_t i = 0; i < 8; ++i) {
            const double value = radius[static_cast<std::size_t>(box.connectivity[8 * std::size_t{cell} + i])];
            low = std::min(low, value);
            high = std::max(high, value);
        }
        EXPECT_TRUE(low < 1.7 && high >= 1.7) << cell;
    }
    const std::vector<double> interpolated = interpolate(surface, mesh, radius);
    for (const float value : interpolated) EXPECT_NEAR(value, 1.7, 1e-5);
}

TEST(Mesh, IsTheSameFromCellsFromFacesAndFromPolyhedra) {
    const Box box(11);
    const Mesh mesh = box.mesh();
    const Polygons wanted = polygons_of(mesh, contour(mesh, box.radius(), 2));

    std::vector<std::uint64_t> cell_offset, face_offset;
    std::vector<Index> face_vertex;
    box.faces_of_cells(cell_offset, face_offset, face_vertex);
    const Mesh polyhedra = Mesh::from_polyhedra({box.points, 3}, cell_offset, face_offset, face_vertex);
    EXPECT_EQ(polygons_of(polyhedra, contour(polyhedra, box.radius(), 2)), wanted);

    // Builds the mesh from faces with owner and neighbor. Interior faces come from the stored mesh, in the caller's
    // ids.
    const FaceMeshView& stored = mesh.stored();
    std::vector<std::uint64_t> once{0};
    std::vector<std::int32_t> vertices, owner, neighbour;
    for (Index face = 0; face < stored.face_count(); ++face) {
        for (const Index v : stored.loop(face))
            vertices.push_back(static_cast<std::int32_t>(mesh.original_vertex()[v]));
        once.push_back(vertices.size());
        owner.push_back(static_cast<std::int32_t>(mesh.original_cell()[stored.owner[face]]));
        const Index other = stored.neighbour[face];
        neighbour.push_back(other == none ? -1 : static_cast<std::int32_t>(mesh.original_cell()[other]));
    }
    const Mesh faces = Mesh::from_faces({box.points, 3}, once, vertices, owner, neighbour);
    EXPECT_EQ(faces.cell_count(), box.types.size());
    EXPECT_EQ(polygons_of(faces, contour(faces, box.radius(), 2)), wanted);
}

TEST(Mesh, TakesPolyhedraAsBothGenerationsOfVtkStoreThem) {
    Box box(13);
    const Mesh mesh = box.mesh();
    const Polygons wanted = polygons_of(mesh, contour(mesh, box.radius(), 2));
    std::vector<std::uint64_t> cell_offset, face_offset;
    std::vector<Index> face_vertex;
    box.faces_of_cells(cell_offset, face_offset, face_vertex);
    std::ranges::fill(box.types, std::uint8_t{42});

    std::vector<std::int64_t> locations, stream;
    for (std::size_t c = 0; c < box.types.size(); ++c) {
        locations.push_back(static_cast<std::int64_t>(stream.size()));
        stream.push_back(static_cast<std::int64_t>(cell_offset[c + 1] - cell_offset[c]));
        for (std::uint64_t f = cell_offset[c]; f < cell_offset[c + 1]; ++f) {
            stream.push_back(static_cast<std::int64_t>(face_offset[f + 1] - face_offset[f]));
            stream.insert(stream.end(), face_vertex.begin() + static_cast<std::ptrdiff_t>(face_offset[f]),
                          face_vertex.begin() + static_cast<std::ptrdiff_t>(face_offset[f + 1]));
        }
    }
    VtkCells cells = box.cells();
    cells.face_locations = locations;
    cells.faces = stream;
    const Mesh before = Mesh::from_cells({box.points, 3}, cells);
    EXPECT_EQ(polygons_of(before, contour(before, box.radius(), 2)), wanted);

    std::vector<std::int64_t> all_faces(face_offset.size() - 1);
    std::iota(all_faces.begin(), all_faces.end(), 0);
    cells = box.cells();
    cells.cell_face_offsets = cell_offset;
    cells.cell_faces = all_faces;
    cells.face_offsets = face_offset;
    cells.face_connectivity = face_vertex;
    const Mesh since = Mesh::from_cells({box.points, 3}, cells);
    EXPECT_EQ(polygons_of(since, contour(since, box.radius(), 2)), wanted);
}

TEST(Mesh, ReadsAnyNumberTypeAndStride) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    const Polygons wanted = polygons_of(mesh, contour(mesh, box.radius(), 2));
    std::vector<float> padded; // four floats per point; the fourth is NaN
    for (std::size_t i = 0; i < box.points.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) padded.push_back(static_cast<float>(box.points[i + k]));
        padded.push_back(NAN);
    }
    const ArrayView points(padded.data(), NumberType::float32, box.point_count(), 3, 16, 4);
    const std::vector<std::uint32_t> offsets(box.offsets.begin(), box.offsets.end());
    const std::vector<std::int32_t> connectivity(box.connectivity.begin(), box.connectivity.end());
    const std::vector<std::int32_t> types(box.types.begin(), box.types.end());
    const Mesh other = Mesh::from_cells(points, {types, offsets, connectivity});
    EXPECT_EQ(polygons_of(other, contour(other, box.radius(), 2)), wanted);

    std::vector<double> backwards = box.radius();
    std::ranges::reverse(backwards);
    const ArrayView radius(backwards.data() + backwards.size() - 1, NumberType::float64, backwards.size(), 1, -8, 8);
    EXPECT_EQ(polygons_of(mesh, contour(mesh, radius, 2)), wanted);
}

TEST(Mesh, SaysWhatBecameOfTheInput) {
    Box box;
    // Adds a quadratic tetrahedron, a triangle, an inverted cube, and a cell with an id out of range.
    const auto add = [&box](std::uint8_t type, const std::vector<std::int64_t>& ids) {
        box.types.push_back(type);
        box.connectivity.insert(box.connectivity.end(), ids.begin(), ids.end());
        box.offsets.push_back(static_cast<std::int64_t>(box.connectivity.size()));
    };
    const auto first = static_cast<std::int64_t>(box.point_count());
    for (const std::array<double, 3>& at : {std::array{9., 0., 0.}, {10., 0., 0.}, {9., 1., 0.}, {9., 0., 1.}})
        box.points.insert(box.points.end(), at.begin(), at.end());
    add(24, {first, first + 1, first + 2, first + 3, 0, 0, 0, 0, 0, 0});
    add(5, {0, 1, 2});
    add(12, {0, 1, 2, 3, 4, 5, 6, 99999});
    const Mesh mesh = box.mesh();
    const MeshReport& report = mesh.report();
    EXPECT_EQ(report.reduced_cells, 1U);
    EXPECT_EQ(report.skipped_cells, 1U);
    ASSERT_EQ(report.assembled.bad_cells.size(), 1U);
    EXPECT_EQ(report.assembled.bad_cells[0].reason, BadCells::Reason::index_out_of_range);
    EXPECT_THAT(report.assembled.bad_cells[0].first_ids, testing::ElementsAre(Index{Box::n * Box::n * Box::n + 2}));
    EXPECT_GT(report.bytes_copied, 0U);
    EXPECT_EQ(mesh.cell_count(), box.types.size());
    const Surface cut = slice(mesh, {9.2, 0, 0}, {2, 0, 0});
    EXPECT_THAT(cut.polygon_cell, testing::ElementsAre(Index{Box::n * Box::n * Box::n}));
}

TEST(Mesh, MovesWithoutBeingIndexedAnew) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    std::vector<double> points = box.points;
    for (double& at : points) at = 2 * at + 1;
    const Mesh moved = mesh.moved({points, 3});
    EXPECT_EQ(&moved.topology(), &mesh.topology());
    const Surface before = slice(mesh, {2.5, 0, 0}, {1, 0, 0}), after = slice(moved, {6, 0, 0}, {1, 0, 0});
    ASSERT_EQ(before.positions.size(), after.positions.size());
    for (std::size_t i = 0; i < before.positions.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(mesh.stored().surface_origin[k] + double{after.positions[i][k]},
                        2 * (mesh.stored().surface_origin[k] + double{before.positions[i][k]}) + 1, 1e-5);

    Contour slider(Field(mesh, box.radius()));
    Surface surface;
    EXPECT_TRUE(slider.at(2, surface));
    slider.set(Field(moved, box.radius()));
    EXPECT_TRUE(slider.at(2, surface));
    EXPECT_EQ(polygons_of(moved, surface), polygons_of(moved, contour(moved, box.radius(), 2)));
}

TEST(Mesh, IsKeptAliveByWhatIsMadeOfIt) {
    std::optional<Contour> slider;
    Polygons wanted;
    std::optional<Mesh> copy;
    {
        const Box box(7);
        const Mesh mesh = box.mesh();
        wanted = polygons_of(mesh, contour(mesh, box.radius(), 2));
        slider.emplace(Field(mesh, box.radius()));
        copy = mesh;
    }
    Surface surface;
    EXPECT_TRUE(slider->at(2, surface));
    EXPECT_EQ(polygons_of(*copy, surface), wanted);
}

TEST(Mesh, EveryAlgorithmGivesTheSame) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    const std::vector<double> levels{1, 2.2, 1.6};
    const std::vector<Surface> wanted = contour(mesh, box.radius(), levels);
    for (const Algorithm algorithm : {Algorithm::propagation, Algorithm::naive}) {
        const std::vector<Surface> surfaces = contour(mesh, box.radius(), levels, {.algorithm = algorithm});
        for (std::size_t i = 0; i < levels.size(); ++i) {
            EXPECT_EQ(surfaces[i].positions, wanted[i].positions);
            EXPECT_EQ(surfaces[i].normals, wanted[i].normals);
            EXPECT_EQ(surfaces[i].polygon_vertex, wanted[i].polygon_vertex);
            EXPECT_EQ(surfaces[i].polygon_cell, wanted[i].polygon_cell);
        }
    }
    EXPECT_TRUE(contour(mesh, box.radius(), 2, {.normals = {}}).normals.empty());
}

TEST(Mesh, TakesValuesOfCells) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    std::vector<float> x_of_cell;
    for (std::size_t c = 0; c < box.types.size(); ++c)
        x_of_cell.push_back(
            static_cast<float>(box.points[3 * static_cast<std::size_t>(box.connectivity[8 * c])] + 0.5));
    const Surface kept = threshold(mesh, x_of_cell, {0, 1}, true);
    EXPECT_EQ(kept.polygon_cell.size(),
              std::size_t{4 * Box::n + 2 * Box::n * Box::n}); // boundary of one layer of cubes
    Surface surface;
    ASSERT_TRUE(Contour(Field::from_cells(mesh, x_of_cell)).at(2.25, surface));
    for (const Vec3f& at : surface.positions) EXPECT_NEAR(mesh.stored().surface_origin[0] + double{at[0]}, 2.25, 1e-4);
}

TEST(Mesh, GradientsAreThoseOfTheFunction) {
    const Box box(7);
    const Mesh mesh = box.mesh();
    std::vector<double> linear;
    for (std::size_t i = 0; i < box.points.size(); i += 3)
        linear.push_back(3 * box.points[i] - 2 * box.points[i + 1] + 0.5 * box.points[i + 2]);
    for (const Vec3f& gradient : gradients(mesh, linear))
        EXPECT_THAT(gradient, testing::ElementsAre(testing::FloatNear(3, 1e-4), testing::FloatNear(-2, 1e-4),
                                                   testing::FloatNear(0.5, 1e-4)));
}

TEST(Mesh, RefusesWhatDoesNotFitInWords) {
    const Box box;
    const Mesh mesh = box.mesh();
    const auto sentence = [](const auto& call) -> std::string {
        try {
            call();
        } catch (const Error& error) {
            return error.what();
        }
        return "nothing was refused";
    };
    using testing::HasSubstr;
    EXPECT_THAT(sentence([&] { (void)Mesh::from_cells({box.points, 2}, box.cells()); }), HasSubstr("three numbers"));
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_cells({box.points, 3}, {box.types, box.connectivity, box.connectivity});
                }),
                HasSubstr("offsets must have one entry more"));
    std::vector<std::int64_t> falling = box.offsets;
    falling[3] = -4;
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_cells({box.points, 3}, {box.types, falling, box.connectivity});
                }),
                HasSubstr("offsets must rise"));
    std::vector<std::uint8_t> types = box.types;
    types[5] = 42;
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_cells({box.points, 3}, {types, box.offsets, box.connectivity});
                }),
                HasSubstr("polyhedron, but its faces are not given"));
    types[5] = 255;
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_cells({box.points, 3}, {types, box.offsets, box.connectivity});
                }),
                HasSubstr("type 255"));
    types[5] = 24;
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_cells({box.points, 3}, {types, box.offsets, box.points});
                }),
                HasSubstr("must hold integers"));
    const std::vector<std::int64_t> triangle{0, 1, 2}, one{0, 3}, far{4'000'000'000};
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_faces({box.points, 3}, one, triangle, far, {});
                }),
                HasSubstr("owner of face 0 is 4000000000"));
    const std::vector<std::int64_t> farthest{INT64_MAX};
    EXPECT_THAT(sentence([&] {
                    (void)Mesh::from_faces({box.points, 3}, one, triangle, farthest, {});
                }),
                HasSubstr("owner of face 0 is 9223372036854775807"));
    EXPECT_THAT(sentence([&] { (void)contour(mesh, std::vector<float>(3), 1); }), HasSubstr("one number per point"));
    EXPECT_THAT(sentence([&] { (void)slice(mesh, {}, {0, 0, 0}); }), HasSubstr("not zero"));
    EXPECT_THAT(sentence([&] { (void)mesh.moved({box.offsets, 3}); }), HasSubstr("moved points"));
    EXPECT_THAT(sentence([&] { Contour(Field(mesh, box.radius())).set(Field(Box().mesh(), box.radius())); }),
                HasSubstr("another mesh"));
}

} // namespace
} // namespace ciel
