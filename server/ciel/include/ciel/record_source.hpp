// RecordSource: provides the records of a mesh's blocks. A record has a part of the paper's data structure (section
// 2.2) for one block of cells, as bytes. A Topology is a view of these bytes. The bytes may be in memory, in a mapped
// file, or in a file that is read.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ciel {

// A block has one record of each kind. cells: for surfaces, slices and pictures. around: leads from a vertex to its
// half-edges, for gradients. mates: the mates of the half-edges, for the operators of Topology and for
// Algorithm::propagation. Each value is also the first four bytes of such a record, which are ASCII characters.
enum class RecordKind : std::uint32_t {
    cells = 0x6c6c6563,  // "cell"
    around = 0x6e756f72, // "roun"
    mates = 0x6574616d,  // "mate"
};

// The records of one topology. Any thread may call the functions at any time.
class RecordSource {
public:
    RecordSource() = default;
    RecordSource(const RecordSource&) = delete;
    RecordSource& operator=(const RecordSource&) = delete;
    virtual ~RecordSource() = default;

    // Returns the bytes of a record. The address is a multiple of 8 and does not change while the source lives.
    // Throws Error when the bytes cannot be read.
    // If is_trusted() returns false, the bytes may change at any time, for example when another process writes a mapped
    // file. Results may then be wrong, but the ids in them are in range, or Error is thrown. If the bytes may change,
    // at least 1 MiB after the end of each record must be readable. Reason: a 16-bit index that was changed, or a sum
    // of several such indices, may point beyond the end.
    [[nodiscard]] virtual std::span<const std::byte> record(Index block, RecordKind kind) = 0;
    // Returns whether the bytes come from this process and never change. If not, the kernel checks each record when the
    // record is first used.
    [[nodiscard]] virtual bool is_trusted() const { return false; }
    // Returns the size in bytes of the memory that the source has allocated for records, without mapped files.
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
};

} // namespace ciel
