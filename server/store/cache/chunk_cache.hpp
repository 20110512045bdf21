// ChunkCache: maps the chunk files of a dataset and verifies each file at its first use. All refreshes of the dataset
// share one ChunkCache. Thread-safe.
#pragma once

#include "store/cache/mapped_file.hpp"

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace ciel::store {

// Keeps the files that were used last mapped, besides those that somebody holds: the system allows a process 65,530
// mappings, and a dataset may have more chunks.
class ChunkCache {
public:
    static constexpr std::size_t most_kept = 64;

    explicit ChunkCache(AnyLost any_lost) : any_lost_(std::move(any_lost)) {}
    // Returns `file`, mapped. The first call maps the file, compares it with `checksum` (empty: not known) and
    // calls `verify`. If one of these throws, the next call tries again. A file that has been let go and has not
    // changed since is mapped again without these checks. Throws Error when the file was truncated or rewritten since
    // it was mapped.
    [[nodiscard]] std::shared_ptr<const MappedFile> get(const std::filesystem::path& file, std::size_t bytes,
                                                        const std::string& checksum,
                                                        const std::function<void(const MappedFile&)>& verify = {});
    void check_sizes() const;
    void check_intact() const;

private:
    struct Entry {
        std::mutex mutex; // one per chunk, so that a slow read of one chunk does not block others
        std::weak_ptr<const MappedFile> mapped;
        std::optional<FileVersion> verified;
    };
    using Kept = std::list<std::pair<Entry*, std::shared_ptr<const MappedFile>>>;

    [[nodiscard]] Entry& entry(const std::filesystem::path& file);
    void keep(Entry& entry, const std::shared_ptr<const MappedFile>& file);
    void for_each(const std::function<void(const MappedFile&)>& visit) const;

    AnyLost any_lost_;
    mutable std::mutex mutex_; // guards the members below
    std::unordered_map<std::string, std::unique_ptr<Entry>> entries_;
    Kept kept_; // used last first
    std::unordered_map<const Entry*, Kept::iterator> place_;
};

} // namespace ciel::store
