#include "store/cache/paged_file.hpp"

#include "ciel/parallel.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

#include <algorithm>

namespace ciel::store {

PageStates::PageStates(std::size_t file_bytes, PageChecks checks)
    : checks_(std::move(checks)), count_((file_bytes + checks_.page_bytes - 1) / checks_.page_bytes),
      checked_(std::make_unique<std::atomic<bool>[]>(count_)), left_(count_) {}

void PagedFile::load_all() const {
    constexpr std::size_t pages_per_task = 16;
    parallel_for(pages_->count(), pages_per_task, [this](std::size_t begin, std::size_t end) {
        for (std::size_t page = begin; page < end; ++page)
            if (!pages_->is_checked(page)) check(page);
    });
}

std::size_t PagedFile::memory_bytes() const {
    return file_.access() == FileAccess::read ? pages_->checked_count() * pages_->checks().page_bytes : 0;
}

void PagedFile::check(std::size_t page) const {
    const PageChecks& checks = pages_->checks();
    const auto all = file_.bytes();
    const std::size_t begin = page * checks.page_bytes;
    const auto part = all.subspan(begin, std::min(checks.page_bytes, all.size() - begin));
    std::unique_lock<std::mutex> copying;
    if (file_.access() == FileAccess::read) {
        copying = std::unique_lock(copying_[page % copying_.size()]);
        if (pages_->is_checked(page)) return;
    }
    file_.load(part);
    if (!checks.checksums.empty() && checksum_number(part) != checks.checksums[page]) {
        file_.check_intact();
        if (!file_.is_current()) file_.refuse();
        refuse_damage(file_.path(), "does not match its checksum");
    }
    if (checks.numbers) checks.numbers(part);
    pages_->set_checked(page);
}

} // namespace ciel::store
