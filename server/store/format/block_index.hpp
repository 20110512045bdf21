// The index of a mesh's blocks. It lists the file and the offset of each record. It also has the tables of the topology
// (Topology::tables), which must be known before a record is read. Bytes: store/README.md, "Blocks".
#pragma once

#include "ciel/record_source.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace server::store {

// The kinds are in the order in which the index lists them.
inline constexpr std::array<ciel::RecordKind, 3> record_kinds{ciel::RecordKind::cells, ciel::RecordKind::around,
                                                              ciel::RecordKind::mates};

[[nodiscard]] std::size_t place_of_kind(ciel::RecordKind kind); // index of `kind` in record_kinds

struct RecordPlace {
    std::uint16_t file = 0;     // number of the file among the files of the same record kind
    std::uint8_t codec = 0;     // 0: the bytes are the record
    std::uint8_t reserved = 0;  // 0
    std::uint32_t offset = 0;   // offset in the file, in units of 64 bytes
    std::uint32_t stored = 0;   // length in the file, in units of 8 bytes
    std::uint32_t raw = 0;      // length of the record, in units of 8 bytes
    std::uint64_t checksum = 0; // XXH3-64 of the record
};
static_assert(sizeof(RecordPlace) == 24);

inline constexpr std::uint64_t record_alignment = 64, record_word = 8; // units of record offsets and lengths, in bytes

struct BlockIndex {
    std::array<double, 6> bounds{};    // bounds of the first coordinate set: xmin xmax ymin ymax zmin zmax
    std::vector<std::uint64_t> tables; // result of Topology::tables
    std::array<std::vector<std::uint64_t>, 3> file_bytes; // by record kind: the size of each file in bytes
    std::array<std::vector<RecordPlace>, 3> places;       // by record kind, by block
};

[[nodiscard]] std::vector<std::byte> to_bytes(const BlockIndex& index, const std::string& dataset_id);
// Throws Error that names `file` when the bytes are damaged or contradictory, or are of a newer format or of another
// dataset. Does not check the content of the tables, because the kernel does.
[[nodiscard]] BlockIndex parse_block_index(std::span<const std::byte> bytes, const std::string& dataset_id,
                                           const std::filesystem::path& file);

} // namespace server::store
