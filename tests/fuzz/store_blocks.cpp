// Fuzzes the index of blocks, the records and the tables of ranges of a dataset. The first byte selects the file, each
// further three are an edit of it: offset (u2), and the number with which the byte there is combined (xor). All
// checksums are corrected. If the dataset opens, its surfaces, slices and histograms are computed.
#include "support/store_box/box.hpp"

#include "ciel/extract.hpp"
#include "store/files/files.hpp"
#include "store/format/block_index.hpp"
#include "store/format/checksum.hpp"
#include "store/loaded.hpp"

#include <cstring>

namespace {

namespace fs = std::filesystem;
using namespace ciel;
using namespace server;

constexpr const char* files[] = {"blocks/index",      "blocks/cells/0",    "blocks/around/0",   "blocks/mates/0",
                                 "arrays/p/ranges/0", "arrays/U/ranges/0", "positions/ranges/0"};
constexpr std::size_t first_of_records = 1, first_of_ranges = 4;

std::string edited(std::string bytes, const std::uint8_t* edits, std::size_t size) {
    for (; size >= 3; edits += 3, size -= 3) {
        char& byte = bytes[(edits[0] + 256U * edits[1]) % bytes.size()];
        byte = static_cast<char>(byte ^ edits[2]);
    }
    return bytes;
}

// The last eight bytes of an index and of a table of ranges are the checksum of the bytes before.
std::string with_last_checksum(std::string bytes) {
    const std::uint64_t sum = store::checksum_number(store::bytes_of(bytes).first(bytes.size() - sizeof sum));
    std::memcpy(bytes.data() + bytes.size() - sizeof sum, &sum, sizeof sum);
    return bytes;
}

// Returns the index with the checksums of the records in `file`, whose content is now `bytes`.
std::string index_for(const fs::path& path, const std::string& index, std::size_t kind, const std::string& bytes) {
    std::string id = index.substr(16, 32);
    id.erase(id.find_last_not_of('\0') + 1);
    store::BlockIndex mended = store::parse_block_index(store::bytes_of(index), id, path);
    for (store::RecordPlace& place : mended.places[kind])
        place.checksum = store::checksum_number(
            store::bytes_of(bytes).subspan(place.offset * store::record_alignment, place.stored * store::record_word));
    const std::vector<std::byte> made = store::to_bytes(mended, id);
    return {reinterpret_cast<const char*>(made.data()), made.size()};
}

void use(const fs::path& directory) {
    store::LoadedDataset loaded(store::Dataset::open(directory), 1 << 20);
    for (const store::ScalarField& scalar :
         {loaded.scalar("p", 0), loaded.scalar("U:magnitude", 0), loaded.plane(0, {1, 1, 1}, {0.6, 0, 0.8})})
        for (const Algorithm algorithm : {Algorithm::signatures, Algorithm::propagation}) {
            Query query = scalar.query(algorithm);
            Surface surface;
            for (const double nu : {3.5, 0.0, 13.0}) query.extract(nu, true, surface);
        }
    for (const char* scalar : {"p", "U:magnitude"}) (void)loaded.histogram(scalar, 0, 64);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const test::Folder scratch;
    static const fs::path directory = scratch / "box.ciel", mesh = directory / "meshes/0", index = mesh / files[0];
    if (!fs::exists(directory)) test::write_box(directory, test::box(2, 2, 2));
    if (size < 1) return 0;
    const std::size_t which = data[0] % std::size(files);
    const fs::path file = mesh / files[which];
    const std::string before = test::read_file(file), whole_index = test::read_file(index);
    const std::string after = edited(before, data + 1, size - 1);
    const bool is_record = which >= first_of_records && which < first_of_ranges;
    test::overwrite_file(file, is_record ? after : with_last_checksum(after));
    if (is_record) test::overwrite_file(index, index_for(index, whole_index, which - first_of_records, after));
    try {
        use(directory);
    } catch (const Error&) { // only Error is a valid refusal
    }
    test::overwrite_file(file, before);
    test::overwrite_file(index, whole_index);
    return 0;
}
