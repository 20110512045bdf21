// Values and positions are read and checked stretch by stretch. A damaged stretch causes an error when it is read.
#include "ciel/extract.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"
#include "store/loaded.hpp"
#include "store/mesh_arrays.hpp"
#include "store/no_value.hpp"
#include "support/store_box/box.hpp"

#include <cstring>
#include <functional>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A box of 68,921 vertices: p has 5 stretches, U and the positions have 13 each. The value of p is the vertex id.
// Stored and imported ids are equal.
class ValuesToLoadTest : public testing::TestWithParam<FileAccess> {
protected:
    static void SetUpTestSuite() {
        pattern = std::make_unique<test::Folder>();
        test::write_box(*pattern / "box.ciel", test::box(40, 40, 40));
    }
    static void TearDownTestSuite() { pattern.reset(); }
    ValuesToLoadTest() { fs::copy(*pattern / "box.ciel", directory, fs::copy_options::recursive); }

    // Changes a byte in place. `at`: offset of the byte; if negative, from the end.
    static void flip(const fs::path& file, std::ptrdiff_t at) {
        std::string bytes = test::read_file(file);
        bytes.at(at < 0 ? bytes.size() - static_cast<std::size_t>(-at) : static_cast<std::size_t>(at)) ^= 1;
        test::overwrite_file(file, bytes);
    }
    static std::size_t polygons_at(const ScalarField& field, double nu) {
        Query query = field.query();
        Surface surface;
        EXPECT_TRUE(query.extract(nu, true, surface));
        return surface.polygon_cell.size();
    }
    [[nodiscard]] std::shared_ptr<Dataset> open() const {
        return Dataset::open(directory, LackingRanges::computed, GetParam());
    }
    template <class F>
    static std::string error_of(F&& f) {
        try {
            f();
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    }

    static std::unique_ptr<test::Folder> pattern;
    test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";
    const fs::path p = directory / "meshes/0/arrays/p/0.0", positions = directory / "meshes/0/positions/0.0.0";
};
std::unique_ptr<test::Folder> ValuesToLoadTest::pattern;

TEST_P(ValuesToLoadTest, ADamagedPageIsFoundByThoseWhoNeedIt) {
    flip(p, -1);
    LoadedDataset loaded(open(), 1U << 30);
    const ScalarField field = loaded.scalar("p", 0);
    EXPECT_GT(polygons_at(field, 2000.5), 0U);
    for (int attempt = 0; attempt < 2; ++attempt)
        EXPECT_THAT(error_of([&] { (void)polygons_at(field, 68000.5); }),
                    AllOf(HasSubstr(p.string()), HasSubstr("does not match its checksum")));
    EXPECT_GT(polygons_at(field, 2100.5), 0U) << "the others can still be used";
    EXPECT_THAT(error_of([&] { (void)loaded.dataset()->values("p", 0); }), HasSubstr("does not match its checksum"));
    EXPECT_THAT(error_of([&] { loaded.dataset()->verify(); }), HasSubstr(p.string()));
    EXPECT_NO_THROW(loaded.dataset()->check_unchanged()) << "it was damaged before it was opened";
}

TEST_P(ValuesToLoadTest, AnIdIsReadFromItsStretch) {
    const fs::path cells = directory / "meshes/0/original_cell";
    flip(cells / "0", -1);
    const auto dataset = open();
    const Index first = dataset->original_cell(0, 0), last = static_cast<Index>(dataset->info().meshes[0].cells - 1);
    EXPECT_EQ(dataset->original_vertex(0, 17), 17U);
    const auto refused = AllOf(HasSubstr((cells / "0").string()), HasSubstr("does not match its checksum"));
    EXPECT_THAT(error_of([&] { (void)dataset->original_cell(0, last); }), refused);
    EXPECT_EQ(dataset->original_cell(0, 1), first + 1) << "the others can still be used";
    EXPECT_THAT(error_of([&] { (void)dataset->original_cell(0); }), refused);
    EXPECT_THAT(error_of([&] { dataset->verify(); }), refused);

    fs::remove_all(cells / "ranges"); // earlier versions wrote no checksums of stretches
    EXPECT_THAT(error_of([&] { (void)open()->original_cell(0, 1); }), refused) << "all of it is one stretch";
}

// The damage is half way up the box. At its ends every plane reads positions, to compute its range.
TEST_P(ValuesToLoadTest, DamagedPositionsAreFoundByThoseWhoNeedThem) {
    flip(positions, static_cast<std::ptrdiff_t>(fs::file_size(positions) / 2));
    LoadedDataset loaded(open(), 1U << 30);
    EXPECT_GT(polygons_at(loaded.plane(0, {0, 0, 2.5}, {0, 0, 1}), 0), 0U);
    EXPECT_GT(polygons_at(loaded.scalar("p", 0), 2000.5), 0U);
    EXPECT_THAT(error_of([&] {
                    (void)polygons_at(loaded.plane(0, {0, 0, 20.5}, {0, 0, 1}), 0);
                }),
                AllOf(HasSubstr(positions.string()), HasSubstr("does not match its checksum")));
    EXPECT_THAT(error_of([&] { (void)loaded.dataset()->mesh_arrays().points(0, 0); }),
                HasSubstr("does not match its checksum"));
}

// Cut in a memory page, and between two: the rest of a memory page reads as zeros, the next one cannot be read.
TEST_P(ValuesToLoadTest, AFileCutShortIsSaidToHaveShrunk) {
    const auto size = fs::file_size(p);
    for (const auto left : {size - 8, size / 2}) {
        const std::string content = test::read_file(p);
        LoadedDataset loaded(open(), 1U << 30);
        const ScalarField field = loaded.scalar("p", 0);
        fs::resize_file(p, left);
        for (int again = 0; again < 2; ++again)
            EXPECT_THAT(error_of([&] { (void)polygons_at(field, 68000.5); }),
                        AllOf(HasSubstr(p.string()), HasSubstr("has shrunk while it was open")))
                << left;
        EXPECT_FALSE(loaded.dataset()->is_intact());
        test::overwrite_file(p, content);
        EXPECT_THAT(error_of([&] { loaded.dataset()->check_intact(); }), HasSubstr("has shrunk"));
    }
}

// The open dataset still maps the damaged file, so only a dataset that is opened again can read the restored one.
TEST_P(ValuesToLoadTest, ARestoredFileIsOpenedAnew) {
    const std::string content = test::read_file(p);
    flip(p, -1);
    LoadedDataset loaded(open(), 1U << 30);
    const ScalarField field = loaded.scalar("p", 0);
    EXPECT_THROW((void)polygons_at(field, 68000.5), Error);
    test::overwrite_file(scratch / "aside", content);
    fs::rename(scratch / "aside", p);
    EXPECT_THAT(error_of([&] { (void)polygons_at(field, 68000.5); }), HasSubstr("has changed while it was open"));
    EXPECT_FALSE(loaded.dataset()->is_intact());
    LoadedDataset again(open(), 1U << 30);
    EXPECT_GT(polygons_at(again.scalar("p", 0), 68000.5), 0U);
}

TEST_P(ValuesToLoadTest, WithoutChecksumsOfPagesAllIsCheckedAtTheFirstUse) {
    fs::remove(layout::value_ranges(p.parent_path(), 0));
    flip(p, -1);
    LoadedDataset loaded(open(), 1U << 30);
    EXPECT_THAT(error_of([&] { (void)loaded.scalar("p", 0); }), HasSubstr("does not match its checksum"));
}

template <class T>
std::vector<T> read_all(const StoredScalar& scalar) {
    std::vector<T> all(scalar.size());
    scalar.read(Index{0}, std::span(all));
    return all;
}

TEST_P(ValuesToLoadTest, ScalarsAreThoseOfTheWholeArray) {
    LoadedDataset loaded(open(), 1U << 30);
    const auto dataset = loaded.dataset();
    Surface surface;
    const ScalarField field = loaded.scalar("p", 0);
    Query query = field.query();
    ASSERT_TRUE(query.extract(30000.5, false, surface));
    for (const char* name : {"p", "U:x", "U:z", "U:magnitude"}) {
        const ScalarName scalar = parse_scalar(*dataset, name);
        const Values whole = one_scalar(*dataset->find(scalar.array), dataset->values(scalar.array, 0), scalar);
        const auto stored = loaded.stored_scalar(name, 0);
        EXPECT_THAT(read_all<float>(*stored), testing::ElementsAreArray(whole.floats())) << name;
        std::vector<float> expected(surface.points.size()), picked(3);
        interpolate(surface.points, whole.floats(), 1, expected);
        EXPECT_THAT(stored->at(surface.points), testing::ElementsAreArray(expected)) << name;
        stored->read(std::vector<Index>{68920, 0, 17}, std::span(picked));
        EXPECT_THAT(picked, testing::ElementsAre(whole.floats()[68920], whole.floats()[0], whole.floats()[17]));
    }
    surface.points[0].b = 68921;
    EXPECT_THROW((void)loaded.stored_scalar("p", 0)->at(surface.points), Error);
    EXPECT_THROW((void)loaded.stored_scalar("cell:p", 0), Error);
    EXPECT_THROW((void)loaded.stored_scalar("p", 1), NotWritten);
}

TEST_P(ValuesToLoadTest, NumbersOfSomeCellsAreThoseOfTheWholeArray) {
    LoadedDataset loaded(open(), 1U << 30);
    const Values whole = loaded.dataset()->values("cell:p", 0);
    const auto stored = loaded.stored_scalar("cell:p", 0, Association::cell);
    EXPECT_EQ(stored->size(), whole.size());
    const std::vector<Index> some{63999, 0, none, 17, 17};
    const Values found = stored->of(some);
    ASSERT_EQ(found.size(), some.size());
    EXPECT_THAT(found, testing::ElementsAre(whole[63999], whole[0], testing::Truly(is_no_value), whole[17], whole[17]));
    EXPECT_THAT(error_of([&] { (void)stored->of(std::vector<Index>{64000}); }), HasSubstr("another mesh"));
    std::vector<double> pieces;
    stored->for_pieces([&](ValuesView piece) { pieces.insert(pieces.end(), piece.begin(), piece.end()); });
    EXPECT_THAT(pieces, testing::ElementsAreArray(whole.begin(), whole.end()));
}

TEST_P(ValuesToLoadTest, ADamagedPageOfCellsIsFoundByThoseWhoNeedIt) {
    const fs::path cells = directory / "meshes/0/arrays/cell%3Ap/0.0";
    ASSERT_TRUE(fs::exists(cells));
    flip(cells, -1);
    LoadedDataset loaded(open(), 1U << 30);
    const auto stored = loaded.stored_scalar("cell:p", 0, Association::cell);
    EXPECT_EQ(stored->of(std::vector<Index>{5})[0], 5);
    EXPECT_THAT(error_of([&] { (void)stored->of(std::vector<Index>{63999}); }),
                AllOf(HasSubstr(cells.string()), HasSubstr("does not match its checksum")));
    EXPECT_EQ(loaded.histogram("cell:p", 0, 64).counts[0], 1000U) << "it reads no value";
    EXPECT_THAT(error_of([&] { (void)loaded.histogram("cell:p", 0, 100); }), HasSubstr(cells.string()));
}

// Copied stretches count as the process's own memory. Values in them stay readable when the file is truncated.
TEST_P(ValuesToLoadTest, OnlyCopiedPagesCountAsMemory) {
    const auto dataset = open();
    const auto values = dataset->values("p", 0);
    (void)dataset->mesh_arrays().points(0, 0);
    const std::size_t bytes = dataset->memory_bytes();
    if (GetParam() == FileAccess::mapped) {
        EXPECT_EQ(bytes, 0U);
        return;
    }
    EXPECT_GE(bytes, fs::file_size(p) + fs::file_size(positions));
    EXPECT_LE(bytes, fs::file_size(p) + fs::file_size(positions) + 2 * stretch_bytes);
    fs::resize_file(p, 0);
    EXPECT_EQ(values[68920], 68920);
}

TEST_P(ValuesToLoadTest, AFileThatIsTruncatedMeanwhileIsNamed) {
    LoadedDataset loaded(open(), 1U << 30);
    const ScalarField field = loaded.scalar("p", 0);
    EXPECT_GT(polygons_at(field, 2000.5), 0U);
    fs::resize_file(p, fs::file_size(p) / 2);
    const std::string error = error_of([&] {
        (void)polygons_at(field, 68000.5);
        loaded.dataset()->check_intact();
    });
    EXPECT_THAT(error, AllOf(HasSubstr(p.string()), HasSubstr("while it was open; restore it")));
    EXPECT_FALSE(loaded.dataset()->is_intact());
}

TEST_P(ValuesToLoadTest, ViewsOfTheSamePositionsShareTheirLoader) {
    const auto dataset = open();
    const FaceMeshView points = dataset->mesh_arrays().points_to_load(0, 0);
    ASSERT_NE(points.loader, nullptr);
    EXPECT_EQ(dataset->mesh_arrays().points_to_load(0, 0).loader, points.loader);
    EXPECT_EQ(dataset->mesh_arrays().numbered_faces(0, 0).loader, points.loader);
}

TEST_P(ValuesToLoadTest, FieldsOnTheSamePositionsReadThemOnce) {
    constexpr double level = 30000.5, depth = 17.5; // both surfaces have edges at vertex 30001
    const auto at_step_2 = [&](LoadedDataset& data) { return polygons_at(data.scalar("p", 2), level); };
    const auto on_plane = [&](LoadedDataset& data) { return polygons_at(data.plane(0, {0, 0, depth}, {0, 0, 1}), 0); };
    LoadedDataset loaded(open(), 1U << 30);
    EXPECT_GT(polygons_at(loaded.scalar("p", 0), level), 0U);
    flip(positions, std::ptrdiff_t{30001} * 3 * 4);
    EXPECT_GT(at_step_2(loaded), 0U);
    EXPECT_GT(on_plane(loaded), 0U);
    for (const auto& cut : {std::function(at_step_2), std::function(on_plane)}) {
        LoadedDataset another(open(), 1U << 30);
        EXPECT_THAT(error_of([&] { (void)cut(another); }), HasSubstr(positions.string()));
    }
}

// In files without checksums of stretches, as earlier versions wrote them, the u64 at offset 128 is zero. The whole
// array is then checked at its first use.
TEST_P(ValuesToLoadTest, TheOffsetOfTheChecksumsMayBeZero) {
    const fs::path file = layout::value_ranges(p.parent_path(), 0);
    std::string bytes = test::read_file(file);
    std::fill_n(bytes.begin() + 128, 8, '\0');
    const auto content = std::as_bytes(std::span(bytes)).first(bytes.size() - 8);
    const std::uint64_t sum = checksum_number(content);
    std::memcpy(bytes.data() + content.size(), &sum, sizeof sum);
    test::overwrite_file(file, bytes);
    flip(p, -1);
    LoadedDataset loaded(open(), 1U << 30);
    const ScalarField field = loaded.scalar("p", 0);
    EXPECT_THAT(error_of([&] { (void)polygons_at(field, 2000.5); }), HasSubstr("does not match its checksum"));
}

INSTANTIATE_TEST_SUITE_P(Access, ValuesToLoadTest, testing::Values(FileAccess::mapped, FileAccess::read),
                         [](const auto& row) { return row.param == FileAccess::mapped ? "mapped" : "read"; });

} // namespace
} // namespace server::store
