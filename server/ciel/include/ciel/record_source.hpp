// Records: the bytes of a mesh's blocks, of which a Topology is a view (paper, section 2.2). They may lie in memory, in
// a mapped file, or in a file that is read.
#pragma once

#include "ciel/types.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace ciel {

// A block has one record of each kind. `cells`: what surfaces, slices and pictures need. `around`: what leads around a
// vertex, for gradients. `mates`: for the operators and propagation. The values are four characters each, as in files.
enum class RecordKind : std::uint32_t {
    cells = 0x6c6c6563,  // "cell"
    around = 0x6e756f72, // "roun"
    mates = 0x6574616d,  // "mate"
};

class RecordSource {
public:
    RecordSource() = default;
    RecordSource(const RecordSource&) = delete;
    RecordSource& operator=(const RecordSource&) = delete;
    virtual ~RecordSource() = default;

    // Returns the bytes of a record. Their address is a multiple of 8 and stays the same while the source lives. Called
    // from any thread. Throws Error when they cannot be read. The bytes of a source that is not trusted may change at
    // any time, as those of a mapped file do when another process writes the file. Results may then be wrong, but their
    // ids are in range, or Error is thrown. If the bytes may change, at least 1 MiB after the end of each record must
    // be readable, because a changed index of 16 bits, or a sum of a few such indices, may lead there.
    [[nodiscard]] virtual std::span<const std::byte> record(Index block, RecordKind kind) = 0;
    // Returns whether the bytes come from this process and never change. If not, each record is checked when it is
    // first used.
    [[nodiscard]] virtual bool is_trusted() const { return false; }
    // Returns the size of the memory that the source has allocated for records. Mapped bytes do not count.
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
};

} // namespace ciel
