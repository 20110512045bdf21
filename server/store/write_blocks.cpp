#include "store/write_blocks.hpp"

#include "store/files/files.hpp"
#include "store/format/block_index.hpp"
#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"
#include "store/format/layout.hpp"

#include <memory>

namespace server::store {
namespace {

std::size_t aligned(std::size_t bytes) { return (bytes + record_alignment - 1) / record_alignment * record_alignment; }

class RecordFiles {
public:
    RecordFiles(std::filesystem::path mesh, ciel::RecordKind kind, const std::string& dataset_id,
                std::uint64_t most_bytes)
        : mesh_(std::move(mesh)), kind_(kind), most_bytes_(most_bytes), head_(file_head(file_kind(kind), dataset_id)) {
        make_directory(layout::records(mesh_, kind_, 0).parent_path());
    }

    RecordPlace add(std::span<const std::byte> record) {
        if (!file_ || file_->size() + aligned(record.size()) > most_bytes_) begin_file();
        RecordPlace place;
        place.file = static_cast<std::uint16_t>(sizes_.size() - 1);
        place.offset = static_cast<std::uint32_t>(file_->size() / record_alignment);
        place.stored = place.raw = static_cast<std::uint32_t>(record.size() / record_word);
        place.checksum = checksum_number(record);
        file_->append(record);
        static constexpr std::array<std::byte, record_alignment> zeros{};
        file_->append(std::span(zeros).first(aligned(record.size()) - record.size()));
        sizes_.back() = file_->size();
        return place;
    }
    [[nodiscard]] const std::vector<std::uint64_t>& sizes() const { return sizes_; }

private:
    void begin_file() {
        file_ = std::make_unique<NewFile>(layout::records(mesh_, kind_, sizes_.size()));
        file_->append(head_);
        sizes_.push_back(file_->size());
    }

    std::filesystem::path mesh_;
    ciel::RecordKind kind_;
    std::uint64_t most_bytes_;
    std::array<std::byte, file_head_bytes> head_;
    std::unique_ptr<NewFile> file_;
    std::vector<std::uint64_t> sizes_; // in bytes, by file
};

} // namespace

void write_blocks(const std::filesystem::path& mesh, const ciel::Topology& topology, const std::string& dataset_id,
                  const std::array<double, 6>& bounds, std::uint64_t most_file_bytes) {
    BlockIndex index;
    index.bounds = bounds;
    index.tables = topology.tables();
    for (std::size_t kind = 0; kind < record_kinds.size(); ++kind) {
        RecordFiles files(mesh, record_kinds[kind], dataset_id, most_file_bytes);
        for (ciel::Index block = 0; block < topology.block_count(); ++block)
            index.places[kind].push_back(files.add(topology.record(block, record_kinds[kind])));
        index.file_bytes[kind] = files.sizes();
    }
    write_file(layout::block_index(mesh), to_bytes(index, dataset_id));
}

} // namespace server::store
