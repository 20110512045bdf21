#include "store/format/block_index.hpp"

#include "store/format/byte_arrays.hpp"

#include <algorithm>

namespace server::store {
namespace {

// The bytes after the common file head. Offsets are in bytes from the beginning of the file.
struct IndexHead {
    std::array<double, 6> bounds{};
    std::uint64_t blocks = 0;
    std::uint64_t tables_begin = 0, tables_bytes = 0;
    std::uint64_t places_begin = 0;
    std::array<std::uint64_t, 3> files{}; // number of files of each record kind
    std::uint64_t files_begin = 0;
};
static_assert(sizeof(IndexHead) == 112);

void check_place(const RecordPlace& place, std::span<const std::uint64_t> files, const ByteReader& in) {
    if (place.codec != 0) in.refuse_unknown("codec " + std::to_string(place.codec));
    const std::uint64_t begin = place.offset * record_alignment;
    if (place.file >= files.size() || place.stored != place.raw || begin < record_alignment ||
        begin + place.stored * record_word > files[place.file])
        in.refuse_damage("lists a record that is not inside its file");
}

} // namespace

std::size_t place_of_kind(ciel::RecordKind kind) {
    return static_cast<std::size_t>(std::ranges::find(record_kinds, kind) - record_kinds.begin());
}

std::vector<std::byte> to_bytes(const BlockIndex& index, const std::string& dataset_id) {
    IndexHead head;
    head.bounds = index.bounds;
    head.blocks = index.places[0].size();
    head.tables_begin = file_head_bytes + sizeof head;
    head.tables_bytes = index.tables.size() * record_word;
    head.places_begin = head.tables_begin + head.tables_bytes;
    head.files_begin = head.places_begin + record_kinds.size() * head.blocks * sizeof(RecordPlace);
    for (std::size_t kind = 0; kind < record_kinds.size(); ++kind) head.files[kind] = index.file_bytes[kind].size();
    ByteWriter out(FileKind::index, dataset_id);
    out.add(head);
    out.add(std::span<const std::uint64_t>(index.tables));
    for (const auto& places : index.places) out.add(std::span<const RecordPlace>(places));
    for (const auto& sizes : index.file_bytes) out.add(std::span<const std::uint64_t>(sizes));
    return out.finish();
}

BlockIndex parse_block_index(std::span<const std::byte> bytes, const std::string& dataset_id,
                             const std::filesystem::path& file) {
    const ByteReader read(bytes, FileKind::index, dataset_id, file);
    const IndexHead head = read.array<IndexHead>(file_head_bytes, 1).front();
    BlockIndex index;
    index.bounds = head.bounds;
    index.tables = read.array<std::uint64_t>(head.tables_begin, head.tables_bytes / record_word);
    std::uint64_t places_at = head.places_begin, files_at = head.files_begin;
    for (std::size_t kind = 0; kind < record_kinds.size(); ++kind) {
        index.places[kind] = read.array<RecordPlace>(places_at, head.blocks);
        index.file_bytes[kind] = read.array<std::uint64_t>(files_at, head.files[kind]);
        places_at += head.blocks * sizeof(RecordPlace);
        files_at += head.files[kind] * sizeof(std::uint64_t);
        for (const RecordPlace& place : index.places[kind]) check_place(place, index.file_bytes[kind], read);
    }
    return index;
}

} // namespace server::store
