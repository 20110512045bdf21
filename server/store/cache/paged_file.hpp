// PagedFile: a file of numbers. A page is read and compared with its checksum when it is first loaded.
#pragma once

#include "ciel/values_view.hpp"
#include "store/cache/mapped_file.hpp"

#include <functional>
#include <mutex>
#include <vector>

namespace ciel::store {

struct PageChecks {
    std::size_t page_bytes = 0;
    std::vector<std::uint64_t> checksums; // XXH3-64 of each page; empty if not known
    // Throws Error if a page contains a forbidden number, such as a coordinate that is not finite. May be empty.
    std::function<void(std::span<const std::byte>)> numbers{};
};

// Records which pages of a file have been checked, even after the file is unmapped. Thread-safe.
class PageStates {
public:
    PageStates(std::size_t file_bytes, PageChecks checks);

    [[nodiscard]] const PageChecks& checks() const { return checks_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] bool is_checked(std::size_t page) const { return checked_[page].load(std::memory_order_acquire); }
    [[nodiscard]] bool are_all_checked() const { return left_.load(std::memory_order_acquire) == 0; }
    [[nodiscard]] std::size_t checked_count() const { return count_ - left_; }
    void set_checked(std::size_t page) {
        if (!checked_[page].exchange(true, std::memory_order_acq_rel)) left_.fetch_sub(1, std::memory_order_acq_rel);
    }

private:
    PageChecks checks_;
    std::size_t count_;
    std::unique_ptr<std::atomic<bool>[]> checked_;
    std::atomic<std::size_t> left_;
};

// Checks pages as PagedFile::load does, on any thread. `file` must have FileAccess::mapped.
void load_pages(const MappedFile& file, PageStates& pages, std::size_t begin, std::size_t end);

// Thread-safe. A mapped page may change after its check when the file is rewritten. A copied page does not change.
class PagedFile {
public:
    PagedFile(MappedFile file, std::shared_ptr<PageStates> pages) : file_(std::move(file)), pages_(std::move(pages)) {}

    [[nodiscard]] const MappedFile& file() const { return file_; }
    // load checks the pages that contain the bytes from `begin` to `end` - 1. load_all checks all pages. Pages that are
    // checked already are skipped. Both throw Error that names the file when a page cannot be read, does not match its
    // checksum, or contains a forbidden number (PageChecks::numbers). If a checksum is wrong and the file at the path
    // was replaced or changed, the mapping is also marked as lost, so that the dataset is opened again.
    void load(std::size_t begin, std::size_t end) const {
        if (begin >= end || pages_->are_all_checked()) return;
        const std::size_t size = pages_->checks().page_bytes, last = (end - 1) / size;
        for (std::size_t page = begin / size; page <= last; ++page)
            if (!pages_->is_checked(page)) check(page);
    }
    void load_all() const;
    [[nodiscard]] std::size_t memory_bytes() const; // size of copied pages; 0 with FileAccess::mapped

private:
    void check(std::size_t page) const;

    MappedFile file_;
    std::shared_ptr<PageStates> pages_;
    mutable std::array<std::mutex, 16> copying_; // page p uses mutex p % 16, so that a page is copied only once
};

// The caller must load the pages that contain the numbers before it reads the numbers.
struct PagedValues {
    ValuesView values; // empty if `file` is null
    std::shared_ptr<const PagedFile> file;
};

} // namespace ciel::store
