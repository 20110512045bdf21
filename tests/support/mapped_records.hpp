// The records of a topology as they would lie in a mapped file that another process may rewrite.
#pragma once

#include "ciel/topology.hpp"

#include <cstring>
#include <map>
#include <span>
#include <vector>

namespace ciel::test {

// The records follow each other. After the last one comes the 1 MiB that a source whose bytes may change must have
// there (RecordSource).
class MappedRecords final : public RecordSource {
public:
    explicit MappedRecords(const Topology& topology);
    std::span<const std::byte> record(Index block, RecordKind kind) override {
        const auto [begin, size] = places_.at({block, kind});
        return std::as_bytes(std::span(words_)).subspan(begin, size);
    }
    [[nodiscard]] std::size_t memory_bytes() const override { return 0; }

    // The words of all records, without the 1 MiB after them.
    [[nodiscard]] std::span<std::uint16_t> words() {
        return {reinterpret_cast<std::uint16_t*>(words_.data()), bytes_ / sizeof(std::uint16_t)};
    }

private:
    static constexpr std::size_t tail = std::size_t{1} << 20;
    std::map<std::pair<Index, RecordKind>, std::pair<std::size_t, std::size_t>> places_; // begin and size in bytes
    std::vector<std::uint64_t> words_;
    std::size_t bytes_ = 0;
};

inline MappedRecords::MappedRecords(const Topology& topology) {
    for (Index b = 0; b < topology.block_count(); ++b)
        for (const RecordKind kind : {RecordKind::cells, RecordKind::around, RecordKind::mates}) {
            const std::size_t size = topology.record(b, kind).size();
            places_[{b, kind}] = {bytes_, size};
            bytes_ += size;
        }
    words_.resize((bytes_ + tail) / sizeof(words_[0]));
    for (const auto& [name, place] : places_)
        std::memcpy(reinterpret_cast<std::byte*>(words_.data()) + place.first,
                    topology.record(name.first, name.second).data(), place.second);
}

} // namespace ciel::test
