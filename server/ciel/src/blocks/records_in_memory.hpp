// The records of a topology that was built in this process. Not in the paper, which has no blocks.
#pragma once

#include "blocks/record.hpp"

#include <array>
#include <vector>

namespace ciel::detail {

class RecordsInMemory final : public RecordSource {
public:
    explicit RecordsInMemory(std::size_t blocks) : records_(blocks) {}

    // Call it once for each record, on any thread, before the other functions.
    void set(Index block, RecordKind kind, RecordBytes record) { records_[block][place_of(kind)] = std::move(record); }

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
