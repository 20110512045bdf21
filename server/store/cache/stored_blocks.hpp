// StoredBlocks: the records of a mesh's blocks. A record is compared with its checksum when it is first requested.
#pragma once

#include "ciel/topology.hpp"
#include "store/cache/mapped_file.hpp"
#include "store/files/files.hpp"
#include "store/files/local_files.hpp"
#include "store/format/block_index.hpp"

#include <atomic>
#include <memory>
#include <mutex>

namespace server::store {

// Thread-safe. A topology that was made from this object keeps the object alive. When a file is changed in place,
// copied records stay the same, and mapped records read as zeros or as the new content. Any content is safe: a topology
// never accesses memory out of bounds (RecordSource). check_intact throws when a change has been detected.
class StoredBlocks : public std::enable_shared_from_this<StoredBlocks> {
public:
    // Reads the index of the mesh's blocks, but no record. Throws Error that names the file when a file is missing,
    // damaged, of a wrong size, of a newer format, or of another dataset.
    StoredBlocks(const std::filesystem::path& mesh, const std::string& dataset_id, LossCount losses, FileAccess access);
    StoredBlocks(const std::filesystem::path& mesh, const std::string& dataset_id, LossCount losses = no_losses())
        : StoredBlocks(mesh, dataset_id, std::move(losses), access_to(mesh)) {}

    [[nodiscard]] ciel::Topology topology() const;
    // Returns a copy of a record. Throws Error that names the file when the record cannot be read or is damaged.
    [[nodiscard]] std::vector<std::uint64_t> read(ciel::Index block, ciel::RecordKind kind) const;
    // Returns a view of the mapped record. Only for FileAccess::mapped. Throws Error as read does.
    [[nodiscard]] std::span<const std::byte> mapped(ciel::Index block, ciel::RecordKind kind) const;
    [[nodiscard]] ciel::Index block_count() const { return static_cast<ciel::Index>(index_.places[0].size()); }
    // Throws Error when a file has changed and a record no longer matches its checksum. Calls stat once for each file.
    void check_unchanged() const;
    void check_intact() const; // throws Error when a file is known to have changed or shrunk

private:
    struct File {
        explicit File(InputFile file) : in(std::move(file)), changed_at(in.changed_at()) {}

        InputFile in;
        MappedFile mapped;                      // empty with FileAccess::read
        std::array<std::int64_t, 2> changed_at; // result of in.changed_at() when the records were last correct
        std::atomic<bool> has_head = false;     // the head of the file has been checked
        std::atomic<bool> is_lost = false;
    };
    [[nodiscard]] bool read_into(const RecordPlace& place, const File& file, std::vector<std::uint64_t>& record) const;
    void check_head(File& file, ciel::RecordKind kind) const;
    void check_file(std::size_t kind, std::size_t number) const;
    [[noreturn]] void refuse_record(File& file, ciel::Index block) const;
    [[noreturn]] void lose(File& file) const;

    std::string dataset_id_;
    LossCount losses_;
    FileAccess access_;
    BlockIndex index_;
    std::array<std::vector<std::unique_ptr<File>>, 3> files_; // by record kind, by number of the file
    mutable std::mutex checking_;                             // guards changed_at of all files
    // By record kind, by block: 1 if the mapped record has matched its checksum once.
    std::array<std::unique_ptr<std::atomic<std::uint8_t>[]>, 3> verified_;
};

} // namespace server::store
