#include "store/cache/chunk_cache.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

#include <vector>

namespace ciel::store {

std::span<const float> ChunkCache::get(const std::filesystem::path& file, std::size_t bytes, const std::string& sum,
                                       const std::function<void(std::span<const float>)>& verify) {
    Entry* entry = nullptr;
    {
        const std::lock_guard lock(mutex_);
        auto& slot = entries_[file.string()];
        if (!slot) slot = std::make_unique<Entry>();
        entry = slot.get();
    }
    const std::lock_guard lock(entry->mutex);
    if (!entry->ready) {
        MappedFile mapped(file, bytes, any_lost_);
        if (!sum.empty() && checksum(mapped.bytes()) != sum) refuse_damage(file, "does not match its checksum");
        if (verify) verify(mapped.as<float>());
        entry->file = std::move(mapped);
        entry->ready = true;
    }
    entry->file.check_intact();
    return entry->file.as<float>();
}

void ChunkCache::check_sizes() const {
    for_each([](const MappedFile& file) { file.check_size(); });
}

void ChunkCache::check_intact() const {
    for_each([](const MappedFile& file) { file.check_intact(); });
}

void ChunkCache::for_each(const std::function<void(const MappedFile&)>& visit) const {
    std::vector<Entry*> all;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [path, entry] : entries_) all.push_back(entry.get());
    }
    for (Entry* entry : all) {
        const std::lock_guard lock(entry->mutex);
        visit(entry->file);
    }
}

} // namespace ciel::store
