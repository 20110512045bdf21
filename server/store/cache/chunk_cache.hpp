// ChunkCache: maps the chunk files of a dataset and verifies each file at its first use. All refreshes of the dataset
// share one ChunkCache. Thread-safe.
#pragma once

#include "store/cache/mapped_file.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <unordered_map>

namespace ciel::store {

class ChunkCache {
public:
    explicit ChunkCache(AnyLost any_lost) : any_lost_(std::move(any_lost)) {}
    // Returns the values in `file`. The first call maps the file, compares it with `checksum` (empty: not known) and
    // calls `verify`. If one of these throws, the next call tries again. Throws Error when the file was truncated or
    // rewritten since it was mapped.
    [[nodiscard]] std::span<const float> get(const std::filesystem::path& file, std::size_t bytes,
                                             const std::string& checksum,
                                             const std::function<void(std::span<const float>)>& verify = {});
    void check_sizes() const;
    void check_intact() const;

private:
    void for_each(const std::function<void(const MappedFile&)>& visit) const;

    struct Entry {
        std::mutex mutex; // one per chunk, so that a slow read of one chunk does not block others
        MappedFile file;
        bool ready = false;
    };
    AnyLost any_lost_;
    mutable std::mutex mutex_;
    std::unordered_map<std::string, std::unique_ptr<Entry>> entries_;
};

} // namespace ciel::store
