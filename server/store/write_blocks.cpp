#include "store/write_blocks.hpp"

#include "ciel/record_sink.hpp"
#include "store/files/files.hpp"
#include "store/format/block_index.hpp"
#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"
#include "store/format/layout.hpp"

#include <algorithm>
#include <memory>
#include <utility>

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

class BlockFiles final : public ciel::RecordSink {
public:
    BlockFiles(const std::filesystem::path& mesh, const std::string& dataset_id, std::uint64_t most_bytes) {
        for (const ciel::RecordKind kind : record_kinds) files_.emplace_back(mesh, kind, dataset_id, most_bytes);
    }

    void put(ciel::Index block, ciel::RecordKind kind, std::vector<std::uint64_t> record) override {
        std::vector<RecordPlace>& places = places_[place_of_kind(kind)];
        places.resize(std::max<std::size_t>(places.size(), std::size_t{block} + 1));
        places[block] = files_[place_of_kind(kind)].add(std::as_bytes(std::span(record)));
    }
    void list(BlockIndex& index) {
        index.places = std::move(places_);
        for (std::size_t kind = 0; kind < files_.size(); ++kind) index.file_bytes[kind] = files_[kind].sizes();
    }

private:
    std::vector<RecordFiles> files_; // by record kind
    std::array<std::vector<RecordPlace>, record_kinds.size()> places_;
};

template <class Cells>
ciel::TopologyCounts write(const std::filesystem::path& directory, const Cells& cells, const std::string& dataset_id,
                           const std::array<double, 6>& bounds, const BlockSizes& sizes) {
    BlockFiles files(directory, dataset_id, sizes.most_file_bytes);
    ciel::BuiltRecords built = ciel::build_records(cells, files, sizes.topology);
    BlockIndex index;
    index.bounds = bounds;
    index.tables = std::move(built.tables);
    files.list(index);
    write_file(layout::block_index(directory), to_bytes(index, dataset_id));
    return built.counts;
}

} // namespace

ciel::TopologyCounts write_blocks(const std::filesystem::path& directory, const ciel::FaceMeshView& mesh,
                                  const std::string& dataset_id, const std::array<double, 6>& bounds,
                                  const BlockSizes& sizes) {
    return write(directory, mesh, dataset_id, bounds, sizes);
}

ciel::TopologyCounts write_blocks(const std::filesystem::path& directory, const ciel::MatchedCells& cells,
                                  const std::string& dataset_id, const std::array<double, 6>& bounds,
                                  const BlockSizes& sizes) {
    return write(directory, cells, dataset_id, bounds, sizes);
}

} // namespace server::store
