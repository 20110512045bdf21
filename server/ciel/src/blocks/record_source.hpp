// Where the records of a mesh's blocks come from: memory, a mapped file, or a file that is read.
#pragma once

#include "blocks/record.hpp"

namespace ciel {

class RecordSource {
public:
    RecordSource() = default;
    RecordSource(const RecordSource&) = delete;
    RecordSource& operator=(const RecordSource&) = delete;
    virtual ~RecordSource() = default;

    // Returns the bytes of a record, which stay valid as long as the source. Any thread. Throws Error when they cannot
    // be read or do not have their checksum.
    [[nodiscard]] virtual std::span<const std::byte> record(Index block, RecordKind kind) = 0;
    // Returns the memory of the records that is the process's own; mapped bytes are not.
    [[nodiscard]] virtual std::size_t memory_bytes() const = 0;
};

} // namespace ciel
