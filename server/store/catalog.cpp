#include "store/catalog.hpp"

#include "ciel/printable.hpp"
#include "store/files/files.hpp"
#include "store/format/documents.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <sys/stat.h>
#include <thread>
#include <tuple>
#include <utility>

namespace server::store {
namespace {

namespace fs = std::filesystem;

// Inode, size and modification time of a file, which change whenever the file is replaced.
using FileStamp = std::tuple<ino_t, off_t, std::int64_t, std::int64_t>;

FileStamp stamp_of_file(const fs::path& file) {
    struct stat status {};
    if (::stat(file.c_str(), &status) != 0) return {};
    return {status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

// Stamps of the commit marker, and of the file that every writer of late arrays replaces (late_files.hpp).
using Stamp = std::array<FileStamp, 2>;

Stamp stamp_of(const fs::path& dataset) {
    return {stamp_of_file(dataset / layout::commit_marker), stamp_of_file(dataset / layout::late_changes)};
}

bool looks_like_dataset(const fs::path& path) {
    std::error_code error;
    if (path.filename().string().starts_with(".") || !fs::is_directory(path, error)) return false;
    return path.extension() == ".ciel" || fs::exists(path / layout::commit_marker, error);
}

std::string plain_name(const fs::path& dataset) {
    return dataset.extension() == ".ciel" ? dataset.stem().string() : dataset.filename().string();
}

bool is_intact(const LoadedDataset& loaded) {
    try {
        loaded.dataset()->check_unchanged();
        return true;
    } catch (const ciel::Error&) {
        return false;
    }
}

// State of a dataset in memory when poll() copied it under the mutex.
struct Seen {
    std::string name;
    std::shared_ptr<LoadedDataset> loaded;
    bool has_new_marker = false, came_back = false;
};

struct Known {
    fs::path directory;
    std::string problem;
    bool failed = false; // true after add_failed, until the stamp of the commit marker differs from `examined`
    Stamp examined{};    // stamp of the commit marker when `problem` was determined
    std::shared_ptr<LoadedDataset> loaded;
    // Set after a loaded dataset was replaced or damaged. told: on_change was called. refused: open() has failed since.
    // came_back: poll() must call on_change again, because open() succeeded after a failure or on_change threw.
    enum class Lost { no, told, refused, came_back } lost = Lost::no;
    Stamp loaded_stamp{};
    FileStamp late_stamp{}; // like loaded_stamp, for late arrays outside the dataset; set by poll()
    Catalog::Clock::time_point used{};
    std::shared_ptr<std::mutex> opening = std::make_shared<std::mutex>();
};

} // namespace

struct Catalog::State {
    std::vector<fs::path> roots;
    std::size_t field_budget = 0, most_bytes = 0;
    std::optional<FileAccess> access;
    LateSteps late;
    mutable std::mutex mutex;
    std::map<std::string, Known> known;                 // by name
    std::vector<std::weak_ptr<LoadedDataset>> replaced; // removed or damaged datasets, which sessions may still use

    void forget(std::shared_ptr<LoadedDataset>& loaded) {
        if (loaded) replaced.push_back(std::exchange(loaded, nullptr));
    }

    Known& learn(const fs::path& directory) {
        for (auto& [name, each] : known)
            if (each.directory == directory) return each;
        const std::string plain = plain_name(directory);
        std::string name = plain;
        for (int number = 2; known.count(name) > 0; ++number) name = plain + "-" + std::to_string(number);
        known[name].directory = directory;
        return known[name];
    }

    // Entries stay as long as their directories exist, so that a dataset keeps its name (for example NAME-2).
    void scan() {
        for (auto entry = known.begin(); entry != known.end();) {
            Known& each = entry->second;
            const bool stays = each.failed || looks_like_dataset(each.directory);
            if (!stays) forget(each.loaded);
            entry = stays ? std::next(entry) : known.erase(entry);
        }
        for (const fs::path& root : roots) {
            if (looks_like_dataset(root)) {
                (void)learn(root);
                continue;
            }
            std::error_code error;
            std::vector<fs::path> found;
            for (const auto& entry : fs::directory_iterator(root, error))
                if (looks_like_dataset(entry.path())) found.push_back(entry.path());
            std::sort(found.begin(), found.end());
            for (const fs::path& path : found) (void)learn(path);
        }
    }

    static void examine(Known& entry) {
        const Stamp now = stamp_of(entry.directory);
        if (entry.failed && now == entry.examined) return;
        entry.failed = false;
        if (entry.loaded || (now == entry.examined && now != Stamp{})) return;
        entry.examined = now;
        try {
            (void)read_documents(entry.directory);
            entry.problem.clear();
        } catch (const std::exception& error) {
            entry.problem = sentence_for_clients(error);
        }
    }

    [[nodiscard]] std::string names() const {
        std::string text;
        for (const auto& [name, entry] : known) text += (text.empty() ? "" : ", ") + name;
        return text.empty() ? "none" : text;
    }

    [[nodiscard]] FileStamp late_stamp(const LoadedDataset& loaded) const {
        if (late.folder.empty()) return {};
        return stamp_of_file(late.folder / loaded.dataset()->info().id / layout::late_changes);
    }
    void poll(const std::function<void(const std::string&)>& on_change);
    void look_at(const Seen& seen, const std::function<void(const std::string&)>& on_change);
};

Catalog::Catalog(std::vector<fs::path> paths, std::size_t field_budget_bytes, std::size_t most_bytes,
                 std::optional<FileAccess> access, LateSteps late)
    : state_(std::make_unique<State>()) {
    for (fs::path& path : paths) {
        path = fs::absolute(path).lexically_normal();
        if (!path.has_filename()) path = path.parent_path();
        std::error_code error;
        if (!fs::exists(path, error)) refuse(path, "does not exist; check the path");
        if (!fs::is_directory(path, error)) refuse(path, "is a file; make a dataset from the file with 'ciel import'");
    }
    state_->roots = std::move(paths);
    state_->field_budget = field_budget_bytes;
    state_->access = access;
    state_->late = std::move(late);
    state_->most_bytes = most_bytes;
    state_->scan();
}

Catalog::~Catalog() = default;

void Catalog::add_failed(const fs::path& directory, const std::string& problem) {
    const std::lock_guard lock(state_->mutex);
    Known& entry = state_->learn(directory);
    entry.problem = problem;
    entry.failed = true;
    entry.examined = stamp_of(directory); // so that an older import in `directory` is not opened instead
}

std::vector<CatalogEntry> Catalog::list() const {
    const std::lock_guard lock(state_->mutex);
    state_->scan();
    std::vector<CatalogEntry> entries;
    for (auto& [name, entry] : state_->known) {
        State::examine(entry);
        entries.push_back({name, entry.directory, entry.problem});
    }
    return entries;
}

std::shared_ptr<LoadedDataset> Catalog::open(const std::string& name) {
    fs::path directory;
    std::shared_ptr<std::mutex> opening;
    {
        const std::lock_guard lock(state_->mutex);
        if (state_->known.count(name) == 0) state_->scan();
        const auto found = state_->known.find(name);
        if (found == state_->known.end())
            throw ciel::Error("there is no dataset '" + ciel::printable(name) + "'; there are: " + state_->names());
        found->second.used = Clock::now();
        if (found->second.loaded) return found->second.loaded;
        State::examine(found->second);
        if (found->second.failed) throw ciel::Error(found->second.problem);
        directory = found->second.directory;
        opening = found->second.opening;
    }
    // Each dataset has its own mutex, because opening may take long and must not delay other datasets.
    const std::lock_guard one_at_a_time(*opening);
    {
        const std::lock_guard lock(state_->mutex);
        if (const auto found = state_->known.find(name); found != state_->known.end() && found->second.loaded)
            return found->second.loaded;
    }
    give_back({}); // drops unused datasets while all datasets need more than most_bytes
    const Stamp stamp = stamp_of(directory);
    std::shared_ptr<LoadedDataset> loaded;
    std::string problem;
    std::exception_ptr failure;
    try {
        auto dataset = Dataset::open(directory, LackingRanges::computed, state_->access, state_->late.folder);
        loaded = std::make_shared<LoadedDataset>(std::move(dataset), state_->field_budget, state_->late.ask);
    } catch (const std::exception& error) {
        problem = sentence_for_clients(error);
        failure = std::current_exception();
    }
    const std::lock_guard lock(state_->mutex);
    if (const auto found = state_->known.find(name); found != state_->known.end()) {
        Known& entry = found->second;
        state_->forget(entry.loaded);
        entry.loaded = loaded;
        entry.problem = problem;
        if (entry.lost != Known::Lost::no && !loaded) entry.lost = Known::Lost::refused;
        if (loaded) entry.lost = entry.lost == Known::Lost::refused ? Known::Lost::came_back : Known::Lost::no;
        entry.examined = entry.loaded_stamp = stamp;
        entry.late_stamp = {};
    } else if (loaded) {
        state_->replaced.push_back(loaded);
    }
    if (failure) std::rethrow_exception(failure);
    return loaded;
}

std::vector<std::shared_ptr<LoadedDataset>> Catalog::loaded() const {
    const std::lock_guard lock(state_->mutex);
    std::vector<std::shared_ptr<LoadedDataset>> all;
    for (const auto& [name, entry] : state_->known)
        if (entry.loaded) all.push_back(entry.loaded);
    std::erase_if(state_->replaced, [](const auto& dataset) { return dataset.expired(); });
    for (const auto& dataset : state_->replaced)
        if (auto held = dataset.lock()) all.push_back(std::move(held));
    return all;
}

std::size_t Catalog::give_back(Clock::time_point unused_since) {
    // Declared before `lock`, so that the datasets are destroyed after the unlock. Unmapping is slow and needs no lock.
    std::vector<std::shared_ptr<LoadedDataset>> forgotten;
    const std::lock_guard lock(state_->mutex);
    std::vector<Known*> unused; // datasets that only the catalog holds; open() cannot return them while `lock` is held
    std::size_t bytes = 0;
    for (auto& [name, entry] : state_->known) {
        if (!entry.loaded) continue;
        bytes += entry.loaded->memory_bytes();
        if (entry.loaded.use_count() == 1)
            unused.push_back(&entry);
        else
            entry.used = Clock::now();
    }
    std::sort(unused.begin(), unused.end(), [](const Known* a, const Known* b) { return a->used < b->used; });
    for (Known* entry : unused) {
        const bool makes_room = bytes > state_->most_bytes && entry != unused.back();
        if (!makes_room && entry->used >= unused_since) continue;
        bytes -= entry->loaded->memory_bytes();
        forgotten.push_back(std::move(entry->loaded));
    }
    return forgotten.size();
}

void Catalog::State::poll(const std::function<void(const std::string&)>& on_change) {
    std::vector<Seen> all;
    {
        const std::lock_guard lock(mutex);
        for (auto& [name, entry] : known) {
            if (!entry.loaded) continue;
            const Stamp now = stamp_of(entry.directory);
            const FileStamp elsewhere = late_stamp(*entry.loaded);
            const bool is_new = now != entry.loaded_stamp || elsewhere != entry.late_stamp;
            all.push_back({name, entry.loaded, is_new, entry.lost == Known::Lost::came_back});
            entry.loaded_stamp = now;
            entry.late_stamp = elsewhere;
            entry.lost = Known::Lost::no;
        }
    }
    for (const Seen& seen : all) {
        try {
            look_at(seen, on_change);
        } catch (const std::exception&) { // on_change threw, or memory is short; the next poll calls on_change again
            const std::lock_guard lock(mutex);
            if (const auto found = known.find(seen.name); found != known.end())
                found->second.lost = Known::Lost::came_back;
        }
    }
}

// Called without a lock of `mutex`, because it reads the disk, which may be slow.
void Catalog::State::look_at(const Seen& seen, const std::function<void(const std::string&)>& on_change) {
    if (!seen.has_new_marker && is_intact(*seen.loaded)) {
        if (seen.came_back) on_change(seen.name);
        return;
    }
    bool tell = true;
    try {
        tell = seen.loaded->refresh();
    } catch (const std::exception&) { // the next open() opens the new dataset or throws the reason
        const std::lock_guard lock(mutex);
        if (const auto found = known.find(seen.name); found != known.end() && found->second.loaded == seen.loaded) {
            forget(found->second.loaded);
            found->second.lost = Known::Lost::told;
            found->second.examined = {};
        }
    }
    if (tell) on_change(seen.name);
}

std::shared_ptr<void> Catalog::watch(std::function<void(const std::string&)> on_change) {
    return std::make_shared<std::jthread>([this, on_change = std::move(on_change)](const std::stop_token& stop) {
        std::mutex mutex;
        std::condition_variable_any wake;
        while (!stop.stop_requested()) {
            try {
                state_->poll(on_change);
            } catch (const std::bad_alloc&) { // tries again in a second
            }
            std::unique_lock lock(mutex);
            wake.wait_for(lock, stop, std::chrono::seconds(1), [] { return false; });
        }
    });
}

} // namespace server::store
