#include "store/cache/checked_file.hpp"

#include "ciel/parallel.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

#include <algorithm>

namespace server::store {
namespace {

void check_stretch(const MappedFile& file, CheckedStretches& stretches, std::size_t stretch) {
    const StretchChecks& checks = stretches.checks();
    const auto all = file.bytes();
    const std::size_t begin = stretch * checks.bytes_each;
    const auto part = all.subspan(begin, std::min(checks.bytes_each, all.size() - begin));
    file.load(part);
    if (!checks.checksums.empty() && checksum_number(part) != checks.checksums[stretch]) {
        file.check_intact();
        if (!file.is_current()) file.refuse();
        refuse_damage(file.path(), "does not match its checksum");
    }
    if (checks.numbers) checks.numbers(part);
    stretches.set_checked(stretch);
}

} // namespace

void load_stretches(const MappedFile& file, CheckedStretches& stretches, std::size_t begin, std::size_t end) {
    if (begin >= end || stretches.are_all_checked()) return;
    const std::size_t size = stretches.checks().bytes_each, first = begin / size;
    ciel::parallel_for((end - 1) / size + 1 - first, 16, [&](std::size_t from, std::size_t to) {
        for (std::size_t stretch = first + from; stretch < first + to; ++stretch)
            if (!stretches.is_checked(stretch)) check_stretch(file, stretches, stretch);
    });
}

CheckedStretches::CheckedStretches(std::size_t file_bytes, StretchChecks checks)
    : checks_(std::move(checks)), count_((file_bytes + checks_.bytes_each - 1) / checks_.bytes_each),
      checked_(std::make_unique<std::atomic<bool>[]>(count_)), left_(count_) {}

void CheckedFile::load_all() const {
    constexpr std::size_t stretches_per_task = 16;
    ciel::parallel_for(stretches_->count(), stretches_per_task, [this](std::size_t begin, std::size_t end) {
        for (std::size_t stretch = begin; stretch < end; ++stretch)
            if (!stretches_->is_checked(stretch)) check(stretch);
    });
}

std::size_t CheckedFile::memory_bytes() const {
    return file_.access() == FileAccess::read ? stretches_->checked_count() * stretches_->checks().bytes_each : 0;
}

void CheckedFile::check(std::size_t stretch) const {
    std::unique_lock<std::mutex> copying;
    if (file_.access() == FileAccess::read) {
        copying = std::unique_lock(copying_[stretch % copying_.size()]);
        if (stretches_->is_checked(stretch)) return;
    }
    check_stretch(file_, *stretches_, stretch);
}

} // namespace server::store
