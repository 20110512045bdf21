// PagedFile: a file of numbers whose pages are compared with their checksums when they are first read. An unread page
// costs nothing.
#pragma once

#include "ciel/values_view.hpp"
#include "store/cache/mapped_file.hpp"

#include <functional>
#include <mutex>
#include <vector>

namespace ciel::store {

// What the pages of a file are compared with.
struct PageChecks {
    std::size_t page_bytes = 0;
    std::vector<std::uint64_t> checksums; // XXH3-64 by page; empty if none are known
    std::function<void(std::span<const std::byte>)>
        numbers{}; // throws Error if a page has numbers that it must not have
};

// Tells which pages of one version of a file have been checked. Outlives the mappings of the file. Thread-safe.
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

// Checks the pages that hold the bytes from `begin` to `end` - 1 of a file with FileAccess::mapped, unless they are
// checked already. Throws Error like PagedFile::load. Any thread.
void load_pages(const MappedFile& file, PageStates& pages, std::size_t begin, std::size_t end);

// Thread-safe. Pages may change after their check, as all mapped files may (MappedFile). With FileAccess::read, they
// are copied before their check and do not change.
class PagedFile {
public:
    PagedFile(MappedFile file, std::shared_ptr<PageStates> pages) : file_(std::move(file)), pages_(std::move(pages)) {}

    [[nodiscard]] const MappedFile& file() const { return file_; }
    // Check the pages that hold the bytes from `begin` to `end` - 1, or all pages, unless they are checked already.
    // Throw Error that names the file when a page cannot be read, does not match its checksum, or has numbers that it
    // must not have. A wrong checksum loses the mapping if the file at the path was replaced or changed, so that the
    // dataset is opened again.
    void load(std::size_t begin, std::size_t end) const {
        if (begin >= end || pages_->are_all_checked()) return;
        const std::size_t size = pages_->checks().page_bytes, last = (end - 1) / size;
        for (std::size_t page = begin / size; page <= last; ++page)
            if (!pages_->is_checked(page)) check(page);
    }
    void load_all() const;
    [[nodiscard]] std::size_t memory_bytes() const; // of copied pages

private:
    void check(std::size_t page) const;

    MappedFile file_;
    std::shared_ptr<PageStates> pages_;
    mutable std::array<std::mutex, 16> copying_; // page p uses number p % 16, so that each page is copied once
};

// The numbers in a PagedFile. The pages of numbers must be loaded before the numbers are read.
struct PagedValues {
    ValuesView values; // empty if `file` is null
    std::shared_ptr<const PagedFile> file;
};

} // namespace ciel::store
