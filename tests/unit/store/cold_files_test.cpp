// Opening a dataset reads no record and no array from the disk, and a surface reads only the blocks that it crosses.
// The tests ask the system which pages of the files are in its page cache.
#include "ciel/extract.hpp"
#include "ciel/threshold_surface.hpp"
#include "store/loaded.hpp"
#include "store/mesh_arrays.hpp"
#include "support/store_box/box.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>
#include <vector>

namespace server::store {
using namespace ciel;
namespace {

namespace fs = std::filesystem;

class ColdFilesTest : public testing::Test {
protected:
    void SetUp() override {
        test::write_box(directory, test::box(40, 40, 40)); // 16 blocks; `p` has 5 stretches of 64 KiB
        for (const fs::path& file : numbered_files()) forget(file);
        if (cached_in("") > 0) GTEST_SKIP() << "the file system of " << scratch.path() << " keeps pages in memory";
    }

    // Returns the files with records, indices, values and positions.
    [[nodiscard]] std::vector<fs::path> numbered_files() const {
        std::vector<fs::path> files;
        for (const auto& entry : fs::recursive_directory_iterator(directory / "meshes"))
            if (entry.is_regular_file() && std::isdigit(entry.path().filename().string().front()) != 0 &&
                entry.path().parent_path().filename() != "ranges")
                files.push_back(entry.path());
        return files;
    }
    // Returns how many bytes of these files are in the page cache. `part`: counts only files whose path contains it.
    [[nodiscard]] std::size_t cached_in(const std::string& part) const {
        std::size_t bytes = 0;
        for (const fs::path& file : numbered_files())
            if (file.string().find(part) != std::string::npos) bytes += cached(file);
        return bytes;
    }
    [[nodiscard]] std::size_t size_of(const std::string& part) const {
        std::size_t bytes = 0;
        for (const fs::path& file : numbered_files())
            if (file.string().find(part) != std::string::npos) bytes += fs::file_size(file);
        return bytes;
    }

    test::Folder scratch;
    const fs::path directory = scratch / "box.ciel";

private:
    static void forget(const fs::path& file) {
        const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
        ASSERT_GE(descriptor, 0);
        ::fsync(descriptor); // pages that are not yet on the disk cannot be dropped
        ::posix_fadvise(descriptor, 0, 0, POSIX_FADV_DONTNEED);
        ::close(descriptor);
    }
    static std::size_t cached(const fs::path& file) {
        const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
        const std::size_t size = fs::file_size(file);
        if (size == 0) return 0;
        const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
        void* const data = ::mmap(nullptr, size, PROT_READ, MAP_SHARED, descriptor, 0);
        ::close(descriptor);
        std::vector<unsigned char> in_memory((size + page - 1) / page);
        EXPECT_EQ(::mincore(data, size, in_memory.data()), 0);
        ::munmap(data, size);
        std::size_t bytes = 0;
        for (const unsigned char each : in_memory) bytes += (each & 1U) != 0 ? page : 0;
        return bytes;
    }
};

TEST_F(ColdFilesTest, OpeningReadsNoneOfThem) {
    const auto dataset = Dataset::open(directory);
    (void)dataset->info();
    EXPECT_EQ(dataset->steps().size(), 3U);
    EXPECT_EQ(cached_in(""), 0U);
    LoadedDataset loaded(dataset, 1U << 30U);
    const ScalarField field = loaded.scalar("p", 0);
    EXPECT_EQ(field.topology->counts().vertices, 68921U);
    EXPECT_EQ(cached_in(""), 0U) << "a field that nobody has cut";
}

TEST_F(ColdFilesTest, ASurfaceReadsWhatItCrosses) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 30U);
    const ScalarField field = loaded.scalar("p", 0);
    Query query = field.query();
    query.set_normals(Normals::polygons);
    Surface surface;
    ASSERT_TRUE(query.extract(2000.5, true, surface)); // between the first two layers of cells
    ASSERT_GT(surface.polygon_cell.size(), 0U);
    (void)loaded.stored_scalar("U:magnitude", 0)->at(surface.points);
    EXPECT_GT(cached_in("blocks/cells"), 0U);
    EXPECT_LT(cached_in("blocks/cells"), size_of("blocks/cells") / 4);
    EXPECT_LE(cached_in("arrays/p/0.0"), 2U << 16U);
    EXPECT_LE(cached_in("arrays/U/0.0"), 3U << 16U);
    EXPECT_LE(cached_in("positions"), 3U << 16U);
    for (const char* unused : {"blocks/around", "blocks/mates", "faces", "arrays/p/2.0", "arrays/cell"})
        EXPECT_EQ(cached_in(unused), 0U) << unused;
}

TEST_F(ColdFilesTest, TheBoundaryReadsNoOtherFace) {
    const auto dataset = Dataset::open(directory);
    const FaceMeshView boundary = dataset->mesh_arrays().boundary(0, 0);
    const std::vector<CellFace> some{{0, boundary.owner[0]}, {1, boundary.owner[1]}};
    EXPECT_EQ(face_surface(boundary, some).polygon_face.size(), 2U);
    EXPECT_GT(cached_in("faces/face_vertex"), 0U);
    EXPECT_LE(cached_in("positions"), 2U << 16U);
    for (const char* unused : {"blocks", "arrays", "cell_types"}) EXPECT_EQ(cached_in(unused), 0U) << unused;
}

TEST_F(ColdFilesTest, AProbeReadsTheBlockThatItIsIn) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 30U);
    const auto locator = loaded.locator(0);
    EXPECT_EQ(cached_in(""), 0U) << "a locator that nobody has asked";
    const Vec3d place{3.5, 2.5, 1.25};
    const Index cell = locator->cell_at(place);
    ASSERT_NE(cell, none);
    EXPECT_EQ(locator->weights_in(cell, place).size(), 8U + 4U + 2U);
    EXPECT_LT(cached_in("blocks/cells"), size_of("blocks/cells") / 4);
    EXPECT_LE(cached_in("positions"), 3U << 16U);
    for (const char* unused : {"blocks/around", "blocks/mates", "faces", "arrays"})
        EXPECT_EQ(cached_in(unused), 0U) << unused;
}

TEST_F(ColdFilesTest, AHistogramReadsNoValue) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 30U);
    for (const char* scalar : {"p", "U:magnitude", "U:y", "cell:p"})
        EXPECT_EQ(loaded.histogram(scalar, 0, 128).counts.size(), 128U) << scalar;
    EXPECT_EQ(cached_in(""), 0U);
    (void)loaded.histogram("p", 0, 128, std::array{0.0, 9.0});
    EXPECT_GT(cached_in("arrays/p/0.0"), 0U) << "only the array's own range is stored";
}

TEST_F(ColdFilesTest, ValuesOfSomeCellsReadTheirStretches) {
    LoadedDataset loaded(Dataset::open(directory), 1U << 30U);
    const auto values = loaded.stored_scalar("cell:p", 0, Association::cell);
    const std::vector<Index> cells{7, 8, 15};
    (void)values->of(cells);
    EXPECT_GT(cached_in("arrays/cell"), 0U);
    EXPECT_LT(cached_in("arrays/cell"), size_of("arrays/cell") / 4);
}

} // namespace
} // namespace server::store
