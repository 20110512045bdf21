#include "store/cache/chunk_cache.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

#include <vector>

namespace ciel::store {

std::shared_ptr<const MappedFile> ChunkCache::get(const std::filesystem::path& file, std::size_t bytes,
                                                  const std::string& sum,
                                                  const std::function<void(const MappedFile&)>& verify) {
    Entry& of_file = entry(file);
    const std::lock_guard lock(of_file.mutex);
    std::shared_ptr<const MappedFile> mapped = of_file.mapped.lock();
    if (mapped == nullptr) {
        mapped = std::make_shared<const MappedFile>(file, bytes, any_lost_);
        if (of_file.verified != mapped->version()) {
            if (!sum.empty() && checksum(mapped->bytes()) != sum) refuse_damage(file, "does not match its checksum");
            if (verify) verify(*mapped);
            of_file.verified = mapped->version();
        }
        of_file.mapped = mapped;
    }
    mapped->check_intact();
    keep(of_file, mapped);
    return mapped;
}

ChunkCache::Entry& ChunkCache::entry(const std::filesystem::path& file) {
    const std::lock_guard lock(mutex_);
    auto& found = entries_[file.string()];
    if (!found) found = std::make_unique<Entry>();
    return *found;
}

void ChunkCache::keep(Entry& entry, const std::shared_ptr<const MappedFile>& file) {
    Kept let_go; // unmapped after the lock
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
        if (const auto mapped = entry->mapped.lock()) visit(*mapped);
    }
}

} // namespace ciel::store
