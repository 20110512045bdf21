// Mapped files of a dataset that are truncated, overwritten or hit by bit flips. Each case runs in a child process, so
// that a crash is one failed case.
#include "damage/damaged_file.hpp"
#include "damage/every_use.hpp"
#include "store/cache/mapped_file.hpp"
#include "store/cache/watched_mappings.hpp"
#include "support/small_dataset/small_dataset.hpp"
#include "support/store_box/box.hpp"
#include "support/store_box/format_1.hpp"

#include <array>
#include <atomic>
#include <gmock/gmock.h>
#include <numeric>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace ciel::test {
using namespace server;
namespace {

namespace fs = std::filesystem;

enum class Moment { before_first_touch, after_first_touch, all_the_time };
constexpr std::array moments{"before", "after", "while"};
constexpr unsigned patience = 120; // seconds after which a case counts as hanging

struct Data {
    std::string name, cells;
    void (*write)(const fs::path& directory);
    bool is_format_1 = false;
    std::vector<std::string_view> only = {}; // the files that are damaged are below these; empty: all files
};

// Doubles, a second set of coordinates, the solver's numbers, and values on boundary faces.
void write_further_files(const fs::path& directory) {
    using store::Association;
    FaceMesh mesh = box(4, 3, 3);
    std::vector<double> places(mesh.positions.begin(), mesh.positions.end());
    for (double& at : places) at += 1e-9 * at;
    mesh.positions.clear();
    mesh.double_positions = places;
    const std::size_t vertices = places.size() / 3, cells = mesh.cell_types.size();
    std::vector<std::int64_t> vertex_numbers(vertices), cell_numbers(cells);
    std::iota(vertex_numbers.begin(), vertex_numbers.end(), 100);
    std::iota(cell_numbers.begin(), cell_numbers.end(), 1000);
    store::Writer writer(directory, {"box.vtu", "m", vertices, 0, cells, {}});
    const std::vector<store::NamedGroup> groups{{store::Group::Of::faces, "wall", {0, 1, 2}}};
    writer.add_mesh(mesh, identity(vertices), identity(cells), groups, {vertex_numbers, cell_numbers});
    for (double& at : places) at *= 1.01;
    const std::size_t moved = writer.add_coordinates(0, places);
    std::vector<double> p(vertices), c(cells), u(3 * vertices);
    for (std::size_t i = 0; i < u.size(); ++i) u[i] = 0.1 * static_cast<double>(i);
    std::copy_n(u.begin(), vertices, p.begin());
    std::copy_n(u.begin(), cells, c.begin());
    const auto faces = static_cast<std::size_t>(std::ranges::count(mesh.neighbour, none));
    const std::vector<double> of_faces(faces, 0.1);
    writer.add_step(0, 0, moved,
                    std::vector<store::ArrayValues>{{{"p", Association::point, 1, "Pa", ""}, p},
                                                    {{"U", Association::point, 3, "m/s", ""}, u},
                                                    {{"cell:p", Association::cell, 1, "Pa", ""}, c},
                                                    {{"patch:p", Association::boundary_face, 1, "Pa", ""}, of_faces}});
    writer.finish();
}

// The files of `data` that are damaged. Paths relative to the dataset.
std::vector<fs::path> files_of(const Data& data, const fs::path& dataset) {
    std::vector<fs::path> files = mapped_files_in(dataset);
    std::erase_if(files, [&](const fs::path& file) {
        return !data.only.empty() && std::ranges::none_of(data.only, [&](std::string_view part) {
            return file.string().find(part) != std::string::npos;
        });
    });
    return files;
}

const std::array<Data, 4> datasets{
    Data{"kinds", "cell:q", write_small_dataset}, // all kinds of cells, files smaller than a page
    Data{"pages", "cell:p", [](const fs::path& directory) { write_box(directory, box(14, 14, 14)); }},
    Data{"format_1", "cell:p",
         [](const fs::path& directory) {
             write_box(directory, box(3, 2, 2));
             make_format_1(directory, box(3, 2, 2));
             remove_blocks(directory);
         },
         true},
    Data{"further", "cell:p", write_further_files, false, {"/arrays/", "/positions/1", "/solver_"}}};

// Runs `body` in a child process. Returns its result, or how the process ended. The parent has no threads.
std::string in_child(const std::function<std::string()>& body) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) return "no pipe";
    const pid_t child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        ::alarm(patience);
        std::string text;
        try {
            text = body();
        } catch (const std::exception& error) {
            text = std::string("threw ") + error.what();
        }
        const ssize_t written = ::write(ends[1], text.data(), text.size());
        ::_exit(written == static_cast<ssize_t>(text.size()) ? 0 : 1);
    }
    ::close(ends[1]);
    std::string text;
    std::array<char, 4096> buffer{};
    for (ssize_t count = 0; (count = ::read(ends[0], buffer.data(), buffer.size())) > 0;)
        text.append(buffer.data(), static_cast<std::size_t>(count));
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return "was ended by " + std::string(::strsignal(WTERMSIG(status)));
    return WEXITSTATUS(status) == 0 ? text : "ended with status " + std::to_string(WEXITSTATUS(status));
}

engine::ServerOptions options_for(const fs::path& directory, Algorithm algorithm) {
    engine::ServerOptions options;
    options.data = {directory};
    options.extraction = algorithm;
    return options;
}

// "meshes/0/faces/owner/0" -> "faces/owner/0", as error messages name the file.
std::string named(const fs::path& file) { return fs::relative(file, "meshes/0").string(); }

class Damager {
public:
    Damager(fs::path file, Damage how) : file_(std::move(file)), how_(how), content_(read_file(file_)) {}

    void once() const { damage(file_, how_, 1); }
    [[nodiscard]] bool has_changed() const { return read_file(file_) != content_; } // false if ones replaced ones
    void begin() {
        thread_ = std::jthread([this](const std::stop_token& stop) {
            for (unsigned seed = 1; !stop.stop_requested(); ++seed) {
                damage(file_, how_, seed);
                std::this_thread::sleep_for(std::chrono::microseconds(300));
                rewrite(file_, content_);
            }
        });
    }
    void end() { thread_ = {}; }

private:
    fs::path file_;
    Damage how_;
    std::string content_;
    std::jthread thread_;
};

// Damages the file at the given moment and uses the dataset. Returns an empty string when the damage was reported
// correctly.
std::string run_case(const Data& data, const fs::path& directory, const fs::path& file, Damage how, Moment moment,
                     Algorithm algorithm) {
    engine::Server server(options_for(directory, algorithm));
    EveryUse uses(server, directory.stem().string(), data.cells, algorithm);
    uses.open();
    const auto opened = uses.dataset();
    if (moment != Moment::before_first_touch)
        for (const Told& told : uses.run()) return "refused " + told.use + " of what was whole: " + told.sentence;
    Damager damager(directory / file, how);
    // The file's modification time must differ from the time at which it was opened.
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (moment == Moment::all_the_time)
        damager.begin();
    else
        damager.once();
    bool is_named = false;
    for (int round = 0; round < (moment == Moment::all_the_time ? 4 : 1); ++round)
        for (const Told& told : uses.run()) {
            if (told.sentence.empty()) return told.use + " was refused without a sentence";
            is_named = is_named || told.sentence.find(named(file)) != std::string::npos;
        }
    damager.end();
    if (moment == Moment::all_the_time || !damager.has_changed()) return {};
    // Damage to values may stay unreported if they are in memory already or have no checksums, as in format 1.
    if (!holds_indices(file))
        return is_named || moment == Moment::after_first_touch || data.is_format_1 ? "" : "nobody noticed the values";
    try {
        opened->check_unchanged();
        return "nobody noticed";
    } catch (const Error& error) {
        const std::string sentence = error.what();
        return sentence.find(named(file)) != std::string::npos ? "" : "told: " + sentence;
    }
}

class mapped_files : public testing::TestWithParam<std::tuple<std::size_t, Damage, Moment>> {};

TEST_P(mapped_files, damaged_in_place_are_a_sentence_and_nothing_dies) {
    const auto [index, how, moment] = GetParam();
    const Data& data = datasets.at(index);
    const Folder folder;
    ASSERT_EQ(in_child([&] {
                  data.write(folder / "whole.ciel");
                  return std::string();
              }),
              "");
    unsigned number = 0;
    for (const fs::path& file : files_of(data, folder / "whole.ciel")) {
        const fs::path directory = folder / ("case" + std::to_string(++number) + ".ciel");
        fs::copy(folder / "whole.ciel", directory, fs::copy_options::recursive);
        const Algorithm algorithm = number % 2 == 0 ? Algorithm::signatures : Algorithm::propagation;
        EXPECT_EQ(in_child([&, &how = how, &moment = moment] {
                      return run_case(data, directory, file, how, moment, algorithm);
                  }),
                  "")
            << file;
        fs::remove_all(directory);
    }
}

std::string name_of_case(const testing::TestParamInfo<std::tuple<std::size_t, Damage, Moment>>& row) {
    const auto [index, how, moment] = row.param;
    return datasets.at(index).name + "_" + name_of(how) + "_" + moments.at(static_cast<std::size_t>(moment));
}

INSTANTIATE_TEST_SUITE_P(matrix, mapped_files,
                         testing::Combine(testing::Values(0U, 1U, 2U, 3U),
                                          testing::Values(Damage::truncated, Damage::halved, Damage::overwritten,
                                                          Damage::ones, Damage::flipped),
                                          testing::Values(Moment::before_first_touch, Moment::after_first_touch,
                                                          Moment::all_the_time)),
                         name_of_case);

// Polls `holds` until it is true, since the catalog's watch runs about once a second.
bool until(const std::function<bool()>& holds) {
    for (unsigned waited = 0; waited < 10 * patience; ++waited) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

// Damages a file, restores it, and expects the server to open the dataset again. Returns an empty string on success.
std::string run_recovery(const Data& data, const fs::path& directory, const fs::path& file, Damage how) {
    engine::Server server(options_for(directory, Algorithm::signatures));
    EveryUse uses(server, directory.stem().string(), data.cells, Algorithm::signatures);
    uses.open();
    for (const Told& told : uses.run()) return "refused " + told.use + " of what was whole: " + told.sentence;
    const std::string content = read_file(directory / file);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    damage(directory / file, how, 1);
    (void)uses.run();
    replace(directory / file, content);
    const auto is_whole = [&] {
        try {
            uses.open();
            uses.dataset()->check_unchanged();
            return true;
        } catch (const Error&) { // the server still has the damaged dataset, or read the file before it was restored
            return false;
        }
    };
    if (!until(is_whole)) return "was never opened anew";
    for (const Told& told : uses.run()) return "refused " + told.use + " of what is whole again: " + told.sentence;
    return until([] { return store::lost_mapping_count() == 0; }) ? "" : "a lost mapping is kept";
}

class lost_datasets : public testing::TestWithParam<std::tuple<std::size_t, Damage>> {};

TEST_P(lost_datasets, come_back_when_they_are_restored) {
    const auto [index, how] = GetParam();
    const Data& data = datasets.at(index);
    const Folder folder;
    ASSERT_EQ(in_child([&] {
                  data.write(folder / "whole.ciel");
                  return std::string();
              }),
              "");
    unsigned number = 0;
    for (const fs::path& file : files_of(data, folder / "whole.ciel")) {
        if (!holds_indices(file)) continue; // values in memory are not read again, so their damage is not noticed
        const fs::path directory = folder / ("case" + std::to_string(++number) + ".ciel");
        fs::copy(folder / "whole.ciel", directory, fs::copy_options::recursive);
        EXPECT_EQ(in_child([&, &how = how] { return run_recovery(data, directory, file, how); }), "") << file;
    }
}

INSTANTIATE_TEST_SUITE_P(kinds, lost_datasets,
                         testing::Combine(testing::Values(0U, 1U, 2U, 3U),
                                          testing::Values(Damage::truncated, Damage::overwritten)),
                         [](const auto& row) {
                             return datasets.at(std::get<0>(row.param)).name + "_" + name_of(std::get<1>(row.param));
                         });

// Each frame checks for lost mappings. A lost file of one dataset must not affect another dataset.
TEST(lost_files, are_of_one_dataset) {
    const Folder folder;
    EXPECT_EQ(in_child([&]() -> std::string {
                  for (const char* name : {"one.ciel", "other.ciel"}) datasets[1].write(folder / name);
                  const auto one = store::Dataset::open(folder / "one.ciel"),
                             other = store::Dataset::open(folder / "other.ciel");
                  const auto values = one->values("p", 0);
                  damage(folder / "one.ciel/meshes/0/arrays/p/0.0", Damage::truncated, 1);
                  if (values[values.size() - 1] != 0) return "the end is still there";
                  if (one->is_intact()) return "nobody noticed";
                  if (store::lost_mapping_count() != 1) return "counts " + std::to_string(store::lost_mapping_count());
                  return other->is_intact() ? "" : "the other is taken for lost";
              }),
              "");
}

// Other memory pages of the mapping keep showing the file.
TEST(lost_files, lose_only_the_memory_pages_that_cannot_be_read) {
    const Folder folder;
    EXPECT_EQ(in_child([&]() -> std::string {
                  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
                  const std::string content(4 * page, 'x');
                  replace(folder / "file", content);
                  const store::MappedFile file(folder / "file", content.size());
                  const auto byte = [&](std::size_t of_page) {
                      return static_cast<char>(file.bytes()[of_page * page + page / 2]);
                  };
                  damage(folder / "file", Damage::truncated, 1);
                  if (byte(2) != 0) return "the page is still there";
                  if (!file.is_lost()) return "nobody noticed";
                  rewrite(folder / "file", content);
                  if (byte(1) != 'x' || byte(3) != 'x') return "a neighbor is lost, too";
                  return byte(2) == 0 ? "" : "a page came back under its reader";
              }),
              "");
}

// Each lost memory page is a mapping, of which the system allows a process 65,530.
TEST(lost_files, are_lost_whole_after_many_memory_pages) {
    const Folder folder;
    EXPECT_EQ(in_child([&]() -> std::string {
                  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
                  const std::string content(200 * page, 'x');
                  replace(folder / "file", content);
                  const store::MappedFile file(folder / "file", content.size());
                  damage(folder / "file", Damage::truncated, 1);
                  for (std::size_t number = 0; number < 200; number += 2)
                      if (static_cast<char>(file.bytes()[number * page]) != 0) return "a page is still there";
                  rewrite(folder / "file", content);
                  return static_cast<char>(file.bytes()[page]) == 0 ? "" : "the system keeps 200 mappings";
              }),
              "");
}

// The watch has not noticed the change yet, and the kernel's error names no file.
TEST(changed_records, are_named_by_their_file) {
    const Folder folder;
    EXPECT_EQ(in_child([&]() -> std::string {
                  const fs::path directory = folder / "kinds.ciel", record = "meshes/0/blocks/cells/0";
                  datasets[0].write(directory);
                  const auto opened = store::Dataset::open(directory);
                  const auto told = [&]() -> std::string {
                      try {
                          opened->naming_changed_file([] { fail("of the kernel"); });
                      } catch (const Error& error) {
                          return error.what();
                      }
                      return "nothing";
                  };
                  (void)opened->topology(0).record(0, RecordKind::cells); // reads and checks the record
                  if (told() != "of the kernel") return "before the change: " + told();
                  std::this_thread::sleep_for(std::chrono::milliseconds(20)); // so that the file's time differs
                  damage(directory / record, Damage::ones, 1);
                  return told().find(named(record)) != std::string::npos ? "" : "told: " + told();
              }),
              "");
}

} // namespace
} // namespace ciel::test
