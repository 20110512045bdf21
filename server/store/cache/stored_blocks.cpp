#include "store/cache/stored_blocks.hpp"

#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace server::store {
namespace {

// RecordSource requires 1 MiB of readable bytes after a record: a wrong index in a changed record may point to them.
constexpr std::size_t tail_bytes = std::size_t{1} << 20;

class MappedSource final : public ciel::RecordSource {
public:
    explicit MappedSource(std::shared_ptr<const StoredBlocks> blocks) : blocks_(std::move(blocks)) {}

    std::span<const std::byte> record(ciel::Index block, ciel::RecordKind kind) override {
        return blocks_->mapped(block, kind);
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

private:
    std::shared_ptr<const StoredBlocks> blocks_;
};

class CopyingSource final : public ciel::RecordSource {
public:
    explicit CopyingSource(std::shared_ptr<const StoredBlocks> blocks) : blocks_(std::move(blocks)) {
        for (auto& of_kind : kept_) of_kind.resize(blocks_->block_count());
    }

    std::span<const std::byte> record(ciel::Index block, ciel::RecordKind kind) override {
        const std::lock_guard lock(reading_[block % reading_.size()]);
        std::vector<std::uint64_t>& kept = kept_[place_of_kind(kind)].at(block);
        if (kept.empty()) {
            kept = blocks_->read(block, kind);
            bytes_ += kept.size() * record_word;
        }
        return std::as_bytes(std::span(kept));
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return bytes_; }

private:
    std::shared_ptr<const StoredBlocks> blocks_;
    // By record kind, by block; empty until the record is read.
    std::array<std::vector<std::vector<std::uint64_t>>, 3> kept_;
    std::array<std::mutex, 16> reading_;
    std::atomic<std::size_t> bytes_ = 0;
};

BlockIndex read_index(const std::filesystem::path& mesh, const std::string& dataset_id) {
    const auto file = layout::block_index(mesh);
    return parse_block_index(bytes_of(read_text(file, layout::index_bytes)), dataset_id, file);
}

InputFile open_records(const std::filesystem::path& mesh, ciel::RecordKind kind, std::size_t number,
                       std::uint64_t bytes) {
    InputFile file(layout::records(mesh, kind, number));
    if (file.size() != bytes)
        refuse_damage(file.path(), "has " + std::to_string(file.size()) + " bytes, but the index declares " +
                                       std::to_string(bytes) + " bytes");
    return file;
}

} // namespace

StoredBlocks::StoredBlocks(const std::filesystem::path& mesh, const std::string& dataset_id, LossCount losses,
                           FileAccess access)
    : dataset_id_(dataset_id), losses_(std::move(losses)), access_(access), index_(read_index(mesh, dataset_id)) {
    for (std::size_t kind = 0; kind < record_kinds.size(); ++kind) {
        verified_[kind] = std::make_unique<std::atomic<std::uint8_t>[]>(block_count());
        for (std::size_t i = 0; i < index_.file_bytes[kind].size(); ++i) {
            const std::uint64_t bytes = index_.file_bytes[kind][i];
            auto file = std::make_unique<File>(open_records(mesh, record_kinds[kind], i, bytes));
            if (access_ == FileAccess::mapped) {
                file->mapped = MappedFile(file->in.path(), bytes, losses_, tail_bytes);
                file->mapped.expect_random_reads();
            }
            files_[kind].push_back(std::move(file));
        }
    }
}

ciel::Topology StoredBlocks::topology() const {
    const auto tables = std::as_bytes(std::span(index_.tables));
    if (access_ == FileAccess::mapped) return {tables, std::make_unique<MappedSource>(shared_from_this())};
    return {tables, std::make_unique<CopyingSource>(shared_from_this())};
}

void StoredBlocks::check_head(File& file, ciel::RecordKind kind) const {
    if (file.has_head) return;
    const auto mapped = file.mapped.bytes();
    std::array<std::byte, file_head_bytes> head;
    if (mapped.size() < head.size()) {
        file.in.read(0, head);
    } else {
        file.mapped.load(mapped.first(head.size()));
        std::ranges::copy(mapped.first(head.size()), head.begin());
    }
    check_file_head(head, file_kind(kind), dataset_id_, file.in.path());
    file.has_head = true;
}

bool StoredBlocks::read_into(const RecordPlace& place, const File& file, std::vector<std::uint64_t>& record) const {
    record.resize(place.raw);
    const auto bytes = std::as_writable_bytes(std::span(record));
    return file.in.read_some(place.offset * record_alignment, bytes) == bytes.size() &&
           checksum_number(bytes) == place.checksum;
}

std::vector<std::uint64_t> StoredBlocks::read(ciel::Index block, ciel::RecordKind kind) const {
    const std::size_t of_kind = place_of_kind(kind);
    const RecordPlace& place = index_.places[of_kind].at(block);
    File& file = *files_[of_kind][place.file];
    check_head(file, kind);
    std::vector<std::uint64_t> record;
    if (!read_into(place, file, record)) refuse_record(file, block);
    return record;
}

std::span<const std::byte> StoredBlocks::mapped(ciel::Index block, ciel::RecordKind kind) const {
    const std::size_t of_kind = place_of_kind(kind);
    const RecordPlace& place = index_.places[of_kind].at(block);
    File& file = *files_[of_kind][place.file];
    const auto record = file.mapped.bytes().subspan(place.offset * record_alignment, place.raw * record_word);
    std::atomic<std::uint8_t>& verified = verified_[of_kind][block];
    if (verified != 0) return record;
    check_head(file, kind);
    file.mapped.load(record);
    if (checksum_number(record) != place.checksum) refuse_record(file, block);
    verified = 1;
    return record;
}

void StoredBlocks::refuse_record(File& file, ciel::Index block) const {
    const std::lock_guard lock(checking_);
    if (file.in.changed_at() != file.changed_at) lose(file);
    refuse_damage(file.in.path(), "does not match the checksum of block " + std::to_string(block));
}

void StoredBlocks::check_unchanged() const {
    check_intact();
    const std::lock_guard lock(checking_);
    for (std::size_t kind = 0; kind < record_kinds.size(); ++kind)
        for (std::size_t number = 0; number < files_[kind].size(); ++number) check_file(kind, number);
}

void StoredBlocks::check_file(std::size_t kind, std::size_t number) const {
    File& file = *files_[kind][number];
    const auto now = file.in.changed_at();
    std::error_code error;
    const bool was_removed = file.in.is_deleted() && !std::filesystem::exists(file.in.path(), error) && !error;
    if (now == file.changed_at || was_removed) return;
    std::vector<std::uint64_t> record;
    for (const RecordPlace& place : index_.places[kind])
        if (place.file == number && !read_into(place, file, record)) lose(file);
    // `now` was read before the records, so that the next call detects a write that happened meanwhile.
    file.changed_at = now;
}

void StoredBlocks::check_intact() const {
    for (const auto& of_kind : files_)
        for (const auto& file : of_kind)
            if (file->is_lost || file->mapped.is_lost()) lose(*file);
}

void StoredBlocks::lose(File& file) const {
    file.is_lost = true;
    ++*losses_;
    refuse_open_file(file.in.path(), "changed");
}

} // namespace server::store
