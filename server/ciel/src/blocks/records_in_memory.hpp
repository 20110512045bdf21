// The records of a topology that was built in this process. Not in the paper, which has no blocks.
#pragma once

#include "blocks/record.hpp"
#include "ciel/record_sink.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace ciel::detail {

// Call `put` for all records before the other functions.
class RecordsInMemory final : public RecordSink, public RecordSource {
public:
    void put(Index block, RecordKind kind, RecordBytes record) override {
        records_.resize(std::max<std::size_t>(records_.size(), std::size_t{block} + 1));
        records_[block][place_of(kind)] = std::move(record);
    }

    std::span<const std::byte> record(Index block, RecordKind kind) override {
        return std::as_bytes(std::span(records_[block][place_of(kind)]));
    }
    bool is_trusted() const override { return true; }
    std::size_t memory_bytes() const override {
        std::size_t sum = records_.capacity() * sizeof(records_[0]);
        for (const auto& of_block : records_)
            for (const RecordBytes& one : of_block) sum += one.capacity() * sizeof(one[0]);
        return sum;
    }

private:
    [[nodiscard]] static std::size_t place_of(RecordKind kind) {
        return kind == RecordKind::cells ? 0 : kind == RecordKind::around ? 1 : 2;
    }

    std::vector<std::array<RecordBytes, 3>> records_; // by block
};

} // namespace ciel::detail
