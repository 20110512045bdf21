// Catalog: the datasets that a server offers. A name in a request is looked up in a table and never used as a path.
#pragma once

#include "store/loaded.hpp"

#include <chrono>
#include <functional>

namespace server::store {

struct LateSteps {
    std::filesystem::path folder; // for late arrays of datasets that cannot be written to (late_files.hpp)
    AskForStep ask;
};

struct CatalogEntry {
    std::string name;
    std::filesystem::path directory;
    std::string problem; // why the dataset cannot be opened; empty if it can
};

// Thread-safe. Keeps one LoadedDataset per name for all sessions, from the first open() until give_back() drops it.
class Catalog {
public:
    // Each path is a NAME.ciel directory, or a folder that every list() searches for such directories. Throws Error for
    // a path that does not exist or is a file. Datasets with the same name get numbers: NAME-2, NAME-3.
    // field_budget_bytes: most memory of the fields of one dataset. most_bytes: most memory of all datasets together;
    // if they need more, unused datasets are dropped.
    explicit Catalog(std::vector<std::filesystem::path> paths, std::size_t field_budget_bytes = std::size_t{4} << 30,
                     std::size_t most_bytes = std::size_t{8} << 30, std::optional<FileAccess> access = std::nullopt,
                     LateSteps late = {});
    ~Catalog();

    // Lists a dataset that could not be imported. open() refuses it until another dataset is written to `directory`.
    void add_failed(const std::filesystem::path& directory, const std::string& problem);

    [[nodiscard]] std::vector<CatalogEntry> list() const;
    // Throws Error when the dataset cannot be opened. If no dataset has this name, the message lists all names.
    [[nodiscard]] std::shared_ptr<LoadedDataset> open(const std::string& name);

    using Clock = std::chrono::steady_clock;
    // Returns all datasets in memory, also those that were removed or damaged and that callers still hold.
    [[nodiscard]] std::vector<std::shared_ptr<LoadedDataset>> loaded() const;
    // Drops the datasets that only the catalog holds and that were not used since `unused_since`. While all datasets
    // together need more than most_bytes, also drops other datasets that only the catalog holds, the least recently
    // used first. The most recently used of them is kept. Returns the number of dropped datasets.
    std::size_t give_back(Clock::time_point unused_since);

    // Starts a thread that checks once a second whether other processes have appended steps or replaced datasets. For
    // each such dataset, it calls on_change(dataset name); if that throws, again a second later. open() then opens the
    // new dataset. Destroy the returned handle to end the thread: before the catalog, and not within on_change.
    [[nodiscard]] std::shared_ptr<void> watch(std::function<void(const std::string&)> on_change);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace server::store
