// ChunkCache: the mapped chunk files of a dataset and of its refreshed versions (Dataset::refreshed). Thread-safe.
#pragma once

#include "store/cache/checked_file.hpp"

#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>

namespace server::store {

// Keeps the `most_kept` most recently used files mapped, and all files that a caller still holds. Does not keep all
// files mapped, because the system allows a process 65,530 mappings, and a dataset can have more chunks.
class ChunkCache {
public:
    static constexpr std::size_t most_kept = 64;

    ChunkCache(LossCount losses, FileAccess access) : losses_(std::move(losses)), access_(access) {}
    // Returns the mapped `file`, which must have `bytes` bytes. Checks no stretch. Calls `checks` to get the checksums
    // of the stretches when the file is mapped for the first time or has changed. Stretches stay checked when an
    // unchanged file is unmapped and mapped again, except with FileAccess::read. Throws Error when the file was
    // truncated or rewritten while it was mapped.
    [[nodiscard]] std::shared_ptr<const CheckedFile> get(const std::filesystem::path& file, std::size_t bytes,
                                                         const std::function<StretchChecks()>& checks);
    void check_sizes() const;
    void check_intact() const;
    [[nodiscard]] std::size_t memory_bytes() const; // size of copied stretches; 0 with FileAccess::mapped

private:
    struct Entry {
        std::mutex mutex; // one per chunk, so that a slow read of one chunk does not block others
        std::weak_ptr<const CheckedFile> mapped;
        std::optional<FileVersion> version; // version of the file whose stretches `stretches` describes
        std::shared_ptr<CheckedStretches> stretches;
    };
    using Kept = std::list<std::pair<Entry*, std::shared_ptr<const CheckedFile>>>;

    [[nodiscard]] Entry& entry(const std::filesystem::path& file);
    void keep(Entry& entry, const std::shared_ptr<const CheckedFile>& file);
    void for_each(const std::function<void(const CheckedFile&)>& visit) const;

    LossCount losses_;
    FileAccess access_;
    mutable std::mutex mutex_; // guards the members below
    std::unordered_map<std::string, std::unique_ptr<Entry>> entries_;
    Kept kept_; // the most recently used first
    std::unordered_map<const Entry*, Kept::iterator> place_;
};

} // namespace server::store
