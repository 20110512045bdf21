// The datasets a server offers, by name. Names never become paths: a request is looked up in a table made from what the
// administrator named on the command line.
#pragma once

#include "store/loaded.hpp"

#include <chrono>
#include <functional>

namespace ciel::store {

struct CatalogEntry {
    std::string name;
    std::filesystem::path directory;
    std::string problem; // a sentence, when it cannot be opened
};

// Thread-safe. Opens lazily, keeps one LoadedDataset per name, whatever the number of sessions, until it is given back.
class Catalog {
public:
    // Each path is a NAME.ciel directory or a folder that holds some (those are found again on every list()).
    // Throws Error for a path that does not exist or is a file. A name that comes twice gets a number.
    // most_bytes: that all together may have in memory before what nobody uses is given back.
    explicit Catalog(std::vector<std::filesystem::path> paths, std::size_t field_budget_bytes = std::size_t{4} << 30,
                     std::size_t most_bytes = std::size_t{8} << 30);
    ~Catalog();

    // Lists a dataset that could not be made, with the reason, until another stands there.
    void add_failed(const std::filesystem::path& directory, const std::string& problem);

    [[nodiscard]] std::vector<CatalogEntry> list() const;
    // Throws Error naming the datasets that exist when there is none of this name.
    [[nodiscard]] std::shared_ptr<LoadedDataset> open(const std::string& name);

    using Clock = std::chrono::steady_clock;
    [[nodiscard]] std::vector<std::shared_ptr<LoadedDataset>> loaded() const; // those in memory
    // Forgets datasets that nobody but the catalog holds: those unused since then, and while all together have more
    // than most_bytes, the longest unused, but never the last one used. Returns how many.
    std::size_t give_back(Clock::time_point unused_since);

    // Looks for steps appended by other processes, about once a second, and calls on_change(dataset name) from a thread
    // of its own; also when a dataset was replaced by another (open() then gives the new one). Ends when the returned
    // handle is destroyed, which must happen before the catalog is, and never from within on_change. on_change must not
    // throw.
    [[nodiscard]] std::shared_ptr<void> watch(std::function<void(const std::string&)> on_change);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ciel::store
