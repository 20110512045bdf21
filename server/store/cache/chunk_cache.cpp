#include "store/cache/chunk_cache.hpp"

#include <vector>

namespace server::store {

std::shared_ptr<const CheckedFile> ChunkCache::get(const std::filesystem::path& file, std::size_t bytes,
                                                   const std::function<StretchChecks()>& checks) {
    Entry& of_file = entry(file);
    const std::lock_guard lock(of_file.mutex);
    std::shared_ptr<const CheckedFile> mapped = of_file.mapped.lock();
    if (mapped == nullptr) {
        MappedFile again(file, bytes, losses_, 0, access_);
        again.expect_random_reads();
        if (of_file.version != again.version() || access_ == FileAccess::read) {
            of_file.stretches = std::make_shared<CheckedStretches>(bytes, checks());
            of_file.version = again.version();
        }
        mapped = std::make_shared<const CheckedFile>(std::move(again), of_file.stretches);
        of_file.mapped = mapped;
    }
    mapped->file().check_intact();
    keep(of_file, mapped);
    return mapped;
}

ChunkCache::Entry& ChunkCache::entry(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    auto& found = entries_[file.string()];
    if (!found) found = std::make_unique<Entry>();
    return *found;
}

void ChunkCache::keep(Entry& entry, const std::shared_ptr<const CheckedFile>& file) {
    Kept let_go; // destroyed after `lock`, so that the file is unmapped without the lock
    const std::lock_guard lock(mutex_);
    if (const auto known = place_.find(&entry); known != place_.end()) {
        known->second->second = file;
        kept_.splice(kept_.begin(), kept_, known->second);
        return;
    }
    kept_.emplace_front(&entry, file);
    place_[&entry] = kept_.begin();
    if (kept_.size() <= most_kept) return;
    place_.erase(kept_.back().first);
    let_go.splice(let_go.begin(), kept_, std::prev(kept_.end()));
}

void ChunkCache::check_sizes() const {
    for_each([](const CheckedFile& file) { file.file().check_size(); });
}

void ChunkCache::check_intact() const {
    for_each([](const CheckedFile& file) { file.file().check_intact(); });
}

std::size_t ChunkCache::memory_bytes() const {
    std::size_t bytes = 0;
    for_each([&](const CheckedFile& file) { bytes += file.memory_bytes(); });
    return bytes;
}

void ChunkCache::for_each(const std::function<void(const CheckedFile&)>& visit) const {
    std::vector<Entry*> all;
    {
        const std::lock_guard lock(mutex_);
        for (const auto& [path, entry] : entries_) all.push_back(entry.get());
    }
    for (Entry* entry : all) {
        const std::lock_guard lock(entry->mutex);
        if (const auto mapped = entry->mapped.lock()) visit(*mapped);
    }
}

} // namespace server::store
