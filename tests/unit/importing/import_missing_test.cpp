// Runs the real ciel-import: which inputs are imported, when they are imported again, and what remains after a failure.
#include "ciel/types.hpp"
#include "importing/import_missing.hpp"
#include "store/dataset.hpp"
#include "store/writer.hpp"
#include "support/folder.hpp"

#include <chrono>
#include <fstream>
#include <gmock/gmock.h>

namespace server::importing {
using namespace server::store;
using namespace ciel;
namespace {

namespace fs = std::filesystem;
using std::chrono::hours;

class ImportMissing : public ::testing::Test {
protected:
    fs::path write(const fs::path& name, const std::string& content) const {
        fs::create_directories((root_ / name).parent_path());
        std::ofstream(root_ / name) << content;
        return root_ / name;
    }

    fs::path write_cube(const fs::path& name) const {
        return write(name,
                     "# vtk DataFile Version 3.0\nt\nASCII\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n"
                     "SPACING 1 1 1\nPOINT_DATA 8\nSCALARS p float 1\nLOOKUP_TABLE default\n1 2 3 4 5 6 7 8\n");
    }

    // An OpenFOAM case of one hexahedron with a field at the times 1 and 2.
    fs::path write_case(const fs::path& name) const {
        const auto header = [](const std::string& kind, const std::string& object) {
            return "FoamFile\n{\n version 2.0;\n format ascii;\n class " + kind + ";\n object " + object + ";\n}\n";
        };
        const fs::path mesh = name / "constant/polyMesh";
        write(name / "system/controlDict",
              header("dictionary", "controlDict") + "startTime 0;\nendTime 2;\ndeltaT 1;\nwriteInterval 1;\n");
        write(mesh / "points", header("vectorField", "points") +
                                   "8\n(\n(0 0 0)\n(1 0 0)\n(1 1 0)\n(0 1 0)\n(0 0 1)\n(1 0 1)\n(1 1 1)\n(0 1 1)\n)\n");
        write(mesh / "faces", header("faceList", "faces") + "6\n(\n4(0 3 2 1)\n4(4 5 6 7)\n4(0 1 5 4)\n4(1 2 6 5)\n"
                                                            "4(2 3 7 6)\n4(3 0 4 7)\n)\n");
        write(mesh / "owner", header("labelList", "owner") + "6\n(\n0\n0\n0\n0\n0\n0\n)\n");
        write(mesh / "neighbour", header("labelList", "neighbour") + "0\n(\n)\n");
        write(mesh / "boundary",
              header("polyBoundaryMesh", "boundary") + "1\n(\nwalls { type wall; nFaces 6; startFace 0; }\n)\n");
        for (const char* time : {"1", "2"})
            write(name / time / "p", header("volScalarField", "p") +
                                         "dimensions [0 0 0 0 0 0 0];\ninternalField uniform " + time +
                                         ";\nboundaryField\n{\n walls { type zeroGradient; }\n}\n");
        write(name / "log.simpleFoam", "a log\n");
        return root_ / name;
    }

    // Sets the modification time of all inputs to yesterday.
    void age() const {
        const auto yesterday = fs::file_time_type::clock::now() - hours(24);
        for (auto entry = fs::recursive_directory_iterator(root_.path()); entry != fs::recursive_directory_iterator();
             ++entry) {
            if (entry->path() == root_ / "imported")
                entry.disable_recursion_pending();
            else
                fs::last_write_time(entry->path(), yesterday);
        }
    }

    static void touch(const fs::path& file) { fs::last_write_time(file, fs::file_time_type::clock::now()); }

    std::vector<fs::path> serve(const std::vector<fs::path>& data) {
        lines_.clear();
        const importing::ImportListener listener{[](double, const std::string&) {},
                                                 [this](const std::string& line) { lines_.push_back(line); }};
        std::vector<fs::path> paths;
        problem_.clear();
        for (const importing::Servable& each :
             importing::import_missing(data, root_ / "imported", {}, listener, cancel_)) {
            paths.push_back(each.path);
            problem_ += each.problem;
        }
        return paths;
    }

    [[nodiscard]] bool imported() const { return !lines_.empty(); } // true when the last serve() imported something

    const test::Folder root_;
    std::vector<std::string> lines_;
    std::string problem_; // message of the last serve(); empty when all inputs were imported
    std::atomic<bool> cancel_{false};
};

TEST_F(ImportMissing, a_file_is_imported_once_and_again_when_it_has_changed) {
    const fs::path file = write_cube("cube.vtk");
    age();
    const auto served = serve({file});
    ASSERT_EQ(served.size(), 1U);
    EXPECT_EQ(served[0].filename(), "cube.ciel");
    EXPECT_THAT(lines_, ::testing::Contains("importing " + file.string()));
    EXPECT_EQ(Dataset::open(served[0])->info().input_cells, 1U);
    EXPECT_EQ(serve({file}), served);
    EXPECT_FALSE(imported());
    touch(file);
    EXPECT_EQ(serve({file}), served);
    EXPECT_TRUE(imported());
    EXPECT_EQ(serve({file}), served);
    EXPECT_FALSE(imported());
}

TEST_F(ImportMissing, a_file_from_the_future_is_not_imported_at_every_start) {
    const fs::path file = write_cube("cube.vtk");
    fs::last_write_time(file, fs::file_time_type::clock::now() + hours(24));
    (void)serve({file});
    (void)serve({file});
    EXPECT_FALSE(imported());
}

TEST_F(ImportMissing, what_changes_while_it_is_imported_is_imported_again) {
    const fs::path file = write_cube("cube.vtk");
    age();
    const importing::ImportListener listener{[&](double, const std::string&) { touch(file); },
                                             [](const std::string&) {}};
    (void)importing::import_missing({file}, root_ / "imported", {}, listener, cancel_);
    (void)serve({file});
    EXPECT_TRUE(imported());
}

TEST_F(ImportMissing, datasets_and_folders_of_them_come_back_as_they_are) {
    const fs::path folder = root_ / "folder";
    fs::create_directories(folder);
    const fs::path dataset = serve({write_cube("cube.vtk")})[0];
    EXPECT_THAT(serve({dataset, folder, folder / ""}), ::testing::ElementsAre(dataset, folder, folder));
    EXPECT_FALSE(imported());
}

TEST_F(ImportMissing, inputs_of_one_name_are_kept_apart) {
    const auto served = serve({write_cube("a/cube.vtk"), write_cube("b/cube.vtk")});
    ASSERT_EQ(served.size(), 2U);
    EXPECT_NE(served[0], served[1]);
    EXPECT_EQ(served[0].filename(), served[1].filename());
}

TEST_F(ImportMissing, a_case_is_as_new_as_what_its_reader_reads) {
    const fs::path directory = write_case("case");
    const fs::path foam = write("case/case.foam", "");
    age();
    const auto served = serve({directory, foam});
    EXPECT_EQ(Dataset::open(served[0])->steps().size(), 2U);
    (void)serve({directory, foam});
    ASSERT_FALSE(imported());
    for (const char* read : {"constant/polyMesh/points", "2/p", "1", "system/controlDict"}) {
        touch(directory / read);
        (void)serve({directory});
        EXPECT_TRUE(imported()) << read;
        (void)serve({foam});
        EXPECT_TRUE(imported()) << read << " by the .foam file";
        age();
        (void)serve({directory, foam});
        EXPECT_FALSE(imported()) << read;
    }
    touch(directory / "log.simpleFoam");
    touch(directory);
    (void)serve({directory, foam});
    EXPECT_FALSE(imported()) << "the reader reads no logs";
    fs::copy(directory / "2", directory / "3", fs::copy_options::recursive);
    EXPECT_EQ(Dataset::open(serve({directory})[0])->steps().size(), 3U);
}

TEST_F(ImportMissing, a_grid_takes_the_solution_beside_it) {
    const fs::path grid = write("cube.xyz", "2 2 2\n0 1 0 1 0 1 0 1\n0 0 1 1 0 0 1 1\n0 0 0 0 1 1 1 1\n");
    std::string values = "2 2 2\n0.5 0 1000 0\n";
    for (int i = 0; i < 40; ++i) values += "1 ";
    const fs::path solution = write("cube.q", values);
    age();
    const auto served = serve({grid});
    EXPECT_THAT(lines_, ::testing::Contains(::testing::HasSubstr("read from cube.q")));
    EXPECT_NE(Dataset::open(served[0])->find("Density"), nullptr);
    (void)serve({grid});
    EXPECT_FALSE(imported());
    touch(solution);
    (void)serve({grid});
    EXPECT_TRUE(imported());
}

TEST_F(ImportMissing, what_cannot_be_imported_is_named_and_leaves_nothing) {
    EXPECT_THROW((void)serve({root_ / "gone.vtk"}), Error);
    const fs::path damaged = write("damaged.vtk", "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n");
    const fs::path good = write_cube("cube.vtk");
    const auto served = serve({damaged, good});
    EXPECT_THAT(problem_, ::testing::HasSubstr(damaged.string()));
    EXPECT_FALSE(fs::exists(served[0].parent_path()));
    EXPECT_EQ(Dataset::open(served[1])->info().input_cells, 1U) << "the others are imported";
    fs::remove_all(root_ / "imported");
    cancel_ = true;
    EXPECT_THROW((void)serve({good}), Error) << "cancelled";
    EXPECT_TRUE(fs::is_empty(root_ / "imported"));
}

TEST_F(ImportMissing, nothing_is_appended_to_a_copy_that_will_be_replaced) {
    const fs::path file = write_cube("cube.vtk");
    const fs::path served = serve({file})[0];
    try {
        (void)Writer::append(served);
        FAIL() << "its steps would be lost at the next start after a change";
    } catch (const Error& error) {
        EXPECT_THAT(error.what(),
                    ::testing::AllOf(::testing::HasSubstr(file.string()), ::testing::HasSubstr("ciel import")));
    }
    for (const auto& entry : fs::directory_iterator(served.parent_path()))
        // Leaves the cache as a version without these additional files wrote it.
        if (entry.path() != served) fs::remove(entry.path());
    ASSERT_EQ(serve({file})[0], served);
    EXPECT_FALSE(imported());
    EXPECT_THROW((void)Writer::append(served), Error);
    fs::copy(served, root_ / "own.ciel", fs::copy_options::recursive);
    EXPECT_NO_THROW((void)Writer::append(root_ / "own.ciel")) << "a user's own copy";
}

TEST_F(ImportMissing, cancelled_at_the_last_moment_it_leaves_a_dataset_or_nothing) {
    const fs::path file = write_cube("cube.vtk");
    for (int attempt = 0; attempt < 5; ++attempt) {
        const importing::ImportListener listener{
            [&](double, const std::string& phase) { cancel_ = phase == "finishing"; }, [](const std::string&) {}};
        try {
            const auto served = importing::import_missing({file}, root_ / "imported", {}, listener, cancel_);
            EXPECT_EQ(Dataset::open(served[0].path)->info().input_cells, 1U);
        } catch (const Error&) {
            EXPECT_TRUE(fs::is_empty(root_ / "imported")) << "said to be cancelled";
        }
        cancel_ = false;
        fs::remove_all(root_ / "imported");
    }
}

TEST_F(ImportMissing, a_failing_change_leaves_the_old_import) {
    const fs::path file = write_cube("cube.vtk");
    const fs::path served = serve({file})[0];
    write("cube.vtk", "no longer what it was");
    fs::last_write_time(file, fs::file_time_type::clock::now() + hours(1));
    (void)serve({file});
    EXPECT_NE(problem_, "");
    EXPECT_EQ(Dataset::open(served)->info().input_cells, 1U);
}

} // namespace
} // namespace server::importing
