// Files of a dataset that somebody truncates, overwrites or flips bits of while they are mapped. Each case runs in a
// process of its own, so that a crash is counted.
#include "damage/damaged_file.hpp"
#include "damage/every_use.hpp"
#include "store/cache/watched_mappings.hpp"
#include "support/small_dataset/small_dataset.hpp"
#include "support/store_box/box.hpp"

#include <array>
#include <atomic>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace ciel::test {
namespace {

namespace fs = std::filesystem;

enum class Moment { before_first_touch, after_first_touch, all_the_time };
constexpr std::array moments{"before", "after", "while"};
constexpr unsigned patience = 120; // seconds after which a case is taken to hang

struct Data {
    std::string name, cells;
    void (*write)(const fs::path& directory);
};
const std::array<Data, 2> datasets{
    Data{"kinds", "cell:q", write_small_dataset}, // cells of every kind, files of less than a page
    Data{"pages", "cell:p", [](const fs::path& directory) { write_box(directory, box(14, 14, 14)); }}};

// Runs `body` in a process of its own; gives what it returned, or how the process ended. The parent has no threads.
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

// "meshes/0/owner/0" -> "owner/0": how the sentence names it, wherever the dataset lies.
std::string named(const fs::path& file) { return fs::relative(file, "meshes/0").string(); }

class Damager {
public:
    Damager(fs::path file, Damage how) : file_(std::move(file)), how_(how), content_(read_file(file_)) {}

    void once() const { damage(file_, how_, 1); }
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

// Empty when all went well.
std::string run_case(const Data& data, const fs::path& directory, const fs::path& file, Damage how, Moment moment,
                     Algorithm algorithm) {
    engine::Server server(options_for(directory, algorithm));
    EveryUse uses(server, directory.stem().string(), data.cells, algorithm);
    uses.open();
    const auto opened = uses.dataset();
    if (moment != Moment::before_first_touch)
        for (const Told& told : uses.run()) return "refused " + told.use + " of what was whole: " + told.sentence;
    Damager damager(directory / file, how);
    std::this_thread::sleep_for(std::chrono::milliseconds(20)); // else the file has the time at which it was opened
    if (moment == Moment::all_the_time)
        damager.begin();
    else
        damager.once();
    for (int round = 0; round < (moment == Moment::all_the_time ? 4 : 1); ++round)
        for (const Told& told : uses.run())
            if (told.sentence.empty()) return told.use + " was refused without a sentence";
    damager.end();
    if (moment == Moment::all_the_time || !holds_indices(file)) return {};
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
    for (const fs::path& file : mapped_files_in(folder / "whole.ciel")) {
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
                         testing::Combine(testing::Values(0U, 1U),
                                          testing::Values(Damage::truncated, Damage::halved, Damage::overwritten,
                                                          Damage::ones, Damage::flipped),
                                          testing::Values(Moment::before_first_touch, Moment::after_first_touch,
                                                          Moment::all_the_time)),
                         name_of_case);

// Waits for what the catalog's watch does about once a second.
bool until(const std::function<bool()>& holds) {
    for (unsigned waited = 0; waited < 10 * patience; ++waited) {
        if (holds()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
    }
    return false;
}

// Restored as it should be, it is opened anew: for everybody, and nothing is left of the loss.
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
        } catch (const Error&) { // the lost one still, or looked at before it was whole
            return false;
        }
    };
    if (!until(is_whole)) return "was never opened anew";
    for (const Told& told : uses.run()) return "refused " + told.use + " of what is whole again: " + told.sentence;
    return until([] { return store::lost_mapping_count() == 0; }) ? "" : "a lost mapping is kept";
}

class lost_datasets : public testing::TestWithParam<Damage> {};

TEST_P(lost_datasets, come_back_when_they_are_restored) {
    for (const Data& data : datasets) {
        const Folder folder;
        ASSERT_EQ(in_child([&] {
                      data.write(folder / "whole.ciel");
                      return std::string();
                  }),
                  "");
        unsigned number = 0;
        for (const fs::path& file : mapped_files_in(folder / "whole.ciel")) {
            if (!holds_indices(file)) continue; // values that were read before are not read again
            const fs::path directory = folder / ("case" + std::to_string(++number) + ".ciel");
            fs::copy(folder / "whole.ciel", directory, fs::copy_options::recursive);
            EXPECT_EQ(in_child([&] { return run_recovery(data, directory, file, GetParam()); }), "") << file;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(kinds, lost_datasets, testing::Values(Damage::truncated, Damage::overwritten),
                         [](const auto& row) { return name_of(row.param); });

// A loss is asked for with each frame: the files of a dataset that lost none are not.
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

} // namespace
} // namespace ciel::test
