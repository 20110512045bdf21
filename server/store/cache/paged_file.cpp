#include "store/cache/paged_file.hpp"

#include "ciel/parallel.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

#include <algorithm>

namespace ciel::store {
namespace {

void check_page(const MappedFile& file, PageStates& pages, std::size_t page) {
    const PageChecks& checks = pages.checks();
    const auto all = file.bytes();
    const std::size_t begin = page * checks.page_bytes;
    const auto part = all.subspan(begin, std::min(checks.page_bytes, all.size() - begin));
    file.load(part);
    if (!checks.checksums.empty() && checksum_number(part) != checks.checksums[page]) {
        file.check_intact();
        if (!file.is_current()) file.refuse();
        refuse_damage(file.path(), "does not match its checksum");
    }
    if (checks.numbers) checks.numbers(part);
    pages.set_checked(page);
}

} // namespace

void load_pages(const MappedFile& file, PageStates& pages, std::size_t begin, std::size_t end) {
    if (begin >= end || pages.are_all_checked()) return;
    const std::size_t size = pages.checks().page_bytes, first = begin / size;
    parallel_for((end - 1) / size + 1 - first, 16, [&](std::size_t from, std::size_t to) {
        for (std::size_t page = first + from; page < first + to; ++page)
            if (!pages.is_checked(page)) check_page(file, pages, page);
    });
}

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
    std::unique_lock<std::mutex> copying;
    if (file_.access() == FileAccess::read) {
        copying = std::unique_lock(copying_[page % copying_.size()]);
        if (pages_->is_checked(page)) return;
    }
    check_page(file_, *pages_, page);
}

} // namespace ciel::store
