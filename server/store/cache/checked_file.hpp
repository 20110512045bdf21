// CheckedFile: a file of numbers. A stretch (format/checksum.hpp) is read and compared with its checksum when it is
// first loaded.
#pragma once

#include "ciel/values_view.hpp"
#include "store/cache/mapped_file.hpp"

#include <functional>
#include <mutex>
#include <vector>

namespace server::store {

struct StretchChecks {
    std::size_t bytes_each = 0;
    std::vector<std::uint64_t> checksums; // XXH3-64 of each stretch; empty if not known
    // Throws Error if a stretch contains a forbidden number, such as a coordinate that is not finite. May be empty.
    std::function<void(std::span<const std::byte>)> numbers{};
};

// Records which stretches of a file have been checked, even after the file is unmapped. Thread-safe.
class CheckedStretches {
public:
    CheckedStretches(std::size_t file_bytes, StretchChecks checks);

    [[nodiscard]] const StretchChecks& checks() const { return checks_; }
    [[nodiscard]] std::size_t count() const { return count_; }
    [[nodiscard]] bool is_checked(std::size_t stretch) const {
        return checked_[stretch].load(std::memory_order_acquire);
    }
    [[nodiscard]] bool are_all_checked() const { return left_.load(std::memory_order_acquire) == 0; }
    [[nodiscard]] std::size_t checked_count() const { return count_ - left_; }
    void set_checked(std::size_t stretch) {
        if (!checked_[stretch].exchange(true, std::memory_order_acq_rel)) left_.fetch_sub(1, std::memory_order_acq_rel);
    }

private:
    StretchChecks checks_;
    std::size_t count_;
    std::unique_ptr<std::atomic<bool>[]> checked_;
    std::atomic<std::size_t> left_;
};

// Like CheckedFile::load, but checks stretches on several threads. REQUIRES: `file` has FileAccess::mapped.
void load_stretches(const MappedFile& file, CheckedStretches& stretches, std::size_t begin, std::size_t end);

// Thread-safe. A mapped stretch may change after its check when the file is rewritten. A copied stretch does not
// change.
class CheckedFile {
public:
    CheckedFile(MappedFile file, std::shared_ptr<CheckedStretches> stretches)
        : file_(std::move(file)), stretches_(std::move(stretches)) {}

    [[nodiscard]] const MappedFile& file() const { return file_; }
    // load checks the stretches that contain the bytes from `begin` to `end` - 1. load_all checks all stretches.
    // Stretches that are checked already are skipped. Both throw Error that names the file when a stretch cannot be
    // read, does not match its checksum, or contains a forbidden number (StretchChecks::numbers). If a checksum is
    // wrong and the file at the path was replaced or changed, the mapping is also marked as lost (mapped_file.hpp), so
    // that the dataset is opened again.
    void load(std::size_t begin, std::size_t end) const {
        if (begin >= end || stretches_->are_all_checked()) return;
        const std::size_t size = stretches_->checks().bytes_each, last = (end - 1) / size;
        for (std::size_t stretch = begin / size; stretch <= last; ++stretch)
            if (!stretches_->is_checked(stretch)) check(stretch);
    }
    void load_all() const;
    [[nodiscard]] std::size_t memory_bytes() const; // size of copied stretches; 0 with FileAccess::mapped

private:
    void check(std::size_t stretch) const;

    MappedFile file_;
    std::shared_ptr<CheckedStretches> stretches_;
    mutable std::array<std::mutex, 16> copying_; // stretch p uses mutex p % 16, so that a stretch is copied only once
};

// Values that the caller must load (CheckedFile::load) before it reads them.
struct ValuesToLoad {
    ciel::ValuesView values; // empty if `file` is null
    std::shared_ptr<const CheckedFile> file;
};

} // namespace server::store
