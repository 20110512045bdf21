// A record: one kind of a block's data as bytes, the same in memory, in a file and in a message. Little-endian.
// Not in the paper.
//
// A record begins with 16 bytes: the kind (u32), the version of the kind (u16), the number of sections (u16), and the
// length of the record in bytes (u64). The table of sections follows, 16 bytes each: id (u16), flags (u16; bit 0:
// critical), bytes of an element (u32), number of elements (u32), and offset in units of 8 bytes (u32). The arrays
// follow. Each array starts at a multiple of 8 bytes; the gaps are zeros. A reader refuses a record with an unknown
// critical section, and skips other unknown sections.
#pragma once

#include "ciel/record_source.hpp"
#include "mesh/read_once.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

namespace ciel::detail {

using RecordBytes = std::vector<std::uint64_t>; // 64-bit words, so that the bytes are aligned

class RecordWriter {
public:
    // Appends a critical section, unless the array is empty. The array must live until `finish`.
    template <class T>
    void add(std::uint16_t id, std::span<const T> array) {
        static_assert(std::is_trivially_copyable_v<T>);
        if (!array.empty()) sections_.push_back({id, critical, sizeof(T), std::as_bytes(array)});
    }
    // Appends a section that a reader may skip, unless the array is empty.
    template <class T>
    void add_optional(std::uint16_t id, std::span<const T> array) {
        if (!array.empty()) sections_.push_back({id, 0, sizeof(T), std::as_bytes(array)});
    }
    [[nodiscard]] RecordBytes finish(RecordKind kind) const;

    static constexpr std::uint16_t critical = 1; // flag of a section

private:
    struct Section {
        std::uint16_t id, flags;
        std::uint32_t element;
        std::span<const std::byte> bytes;
    };
    std::vector<Section> sections_;
};

// Does not own the bytes, which must outlive the view. Their address must be a multiple of 8.
class RecordView {
public:
    // Throws Error for another kind, a newer version, a wrong length, or a section beyond the end or given twice.
    RecordView(std::span<const std::byte> bytes, RecordKind kind);

    // Returns an empty array if the record does not have the section. The address of the empty array is the end of the
    // record, because the bytes there can be read (RecordSource). Throws Error if the elements have another size.
    template <class T>
    [[nodiscard]] std::span<const T> get(std::uint16_t id) const {
        const std::span<const std::byte> found = find(id, sizeof(T));
        return {reinterpret_cast<const T*>(found.data()), found.size() / sizeof(T)};
    }
    // Returns the size of the section's elements in bytes; 0 if the record does not have the section.
    [[nodiscard]] std::size_t element_size(std::uint16_t id) const;
    // Call after the last `get`. Throws Error if the record has a critical section that no `get` asked for.
    void check_all_known() const;

private:
    struct Entry {
        std::uint16_t id, flags;
        std::uint32_t element, count, offset;
    };
    [[nodiscard]] std::span<const std::byte> find(std::uint16_t id, std::size_t element) const;

    std::span<const std::byte> bytes_;
    std::vector<Entry> entries_;
    mutable std::vector<bool> known_; // by entry: whether `get` has returned the section
};

// Throws Error with the message that a record changed while it was used. `what`: the contradiction in the record.
[[noreturn]] void refuse_changed(const char* what);

} // namespace ciel::detail
