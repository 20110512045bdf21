// Chunks mapped and verified at first touch, once for all refreshes of a dataset. Thread-safe.
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
    // Maps `file` on the first call, compares it with `checksum` (empty: not known) and calls `verify`; when one of
    // them throws, the next call tries again. Throws Error when the chunk was lost.
    [[nodiscard]] std::span<const float> get(const std::filesystem::path& file, std::size_t bytes,
                                             const std::string& checksum,
                                             const std::function<void(std::span<const float>)>& verify = {});
    void check_sizes() const;
    void check_intact() const;

private:
    void for_each(const std::function<void(const MappedFile&)>& visit) const;

    struct Entry {
        std::mutex mutex; // of its own: a slow disk under one chunk must not hold up the others
        MappedFile file;
        bool ready = false;
    };
    AnyLost any_lost_;
    mutable std::mutex mutex_;
    std::unordered_map<std::string, std::unique_ptr<Entry>> entries_;
};

} // namespace ciel::store
