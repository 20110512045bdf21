// StoredBlocks: the records of a mesh's blocks in their files. A record is compared with its checksum when it is first
// asked for.
#pragma once

#include "ciel/topology.hpp"
#include "store/cache/mapped_file.hpp"
#include "store/files/files.hpp"
#include "store/files/local_files.hpp"
#include "store/format/block_index.hpp"

#include <atomic>
#include <memory>
#include <mutex>

namespace ciel::store {

// Thread-safe. Topologies that are made from it keep it alive. When a file is found to have been truncated or rewritten
// in place, check_intact throws. Copied records stay as they are; mapped ones may then read as zeros or as the new
// content, and a topology stays in bounds with any content (RecordSource).
class StoredBlocks : public std::enable_shared_from_this<StoredBlocks> {
public:
    // Reads the index of the mesh and opens the files of records; reads nothing of them. Throws Error that names the
    // file when one is missing or has another size, or when the index is damaged, of a newer format, or of a dataset
    // with another id.
    StoredBlocks(const std::filesystem::path& mesh, const std::string& dataset_id, AnyLost any_lost, FileAccess access);
    StoredBlocks(const std::filesystem::path& mesh, const std::string& dataset_id, AnyLost any_lost = none_lost())
        : StoredBlocks(mesh, dataset_id, std::move(any_lost), access_to(mesh)) {}

    // Returns a topology that takes a record when it is first used. is_trusted: this process has written the records,
    // so their content is not checked. Such records are always copied.
    [[nodiscard]] Topology topology(bool is_trusted = false) const;
    // Reads a record. Throws Error that names the file when it cannot be read, is of a newer format or of another
    // dataset, or when the record does not match its checksum.
    [[nodiscard]] std::vector<std::uint64_t> read(Index block, RecordKind kind) const;
    // Returns a record in its mapped file. Throws like read. Only for FileAccess::mapped.
    [[nodiscard]] std::span<const std::byte> mapped(Index block, RecordKind kind) const;
    [[nodiscard]] Index block_count() const { return static_cast<Index>(index_.places[0].size()); }
    // Throws Error when a file was changed in place or replaced, and a record of the open file does not have its
    // checksum. Makes a stat call per file.
    void check_unchanged() const;
    void check_intact() const; // throws Error when a file is known to be lost

private:
    struct File {
        explicit File(InputFile file) : in(std::move(file)), changed_at(in.changed_at()) {}

        InputFile in;
        MappedFile mapped;                      // empty if records are read
        std::array<std::int64_t, 2> changed_at; // when its content was last known to be right
        std::atomic<bool> has_head = false;     // its first bytes were found to be right
        std::atomic<bool> is_lost = false;
    };
    [[nodiscard]] bool read_into(const RecordPlace& place, const File& file, std::vector<std::uint64_t>& record) const;
    void check_head(File& file, RecordKind kind) const;
    void check_file(std::size_t kind, std::size_t number) const;
    [[noreturn]] void refuse_record(File& file, Index block) const;
    [[noreturn]] void lose(File& file) const;

    std::string dataset_id_;
    AnyLost any_lost_;
    FileAccess access_;
    BlockIndex index_;
    std::array<std::vector<std::unique_ptr<File>>, 3> files_; // by kind, by number
    mutable std::mutex checking_;                             // guards changed_at of all files
    // By kind, by block: 1 if the mapped record was once found to have its checksum.
    std::array<std::unique_ptr<std::atomic<std::uint8_t>[]>, 3> verified_;
};

} // namespace ciel::store
