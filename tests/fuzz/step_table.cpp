// Fuzzes the entry of one step in the table of steps: the first byte is the number of arrays, the rest describes them.
// The checksums are right. An accepted step is written to another table and must be read back equal.
#include "store/format/step_table.hpp"
#include "store/files/files.hpp"
#include "store/format/checksum.hpp"
#include "store/format/file_head.hpp"
#include "support/folder.hpp"

#include <cstdlib>
#include <cstring>

namespace {

using namespace ciel;
using namespace server::store;

const std::string id = "0123456789abcdef";

template <class T>
void put(std::vector<std::byte>& out, const T& value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    out.insert(out.end(), bytes.begin(), bytes.end());
}

std::vector<std::byte> head(FileKind kind) {
    const auto bytes = file_head(kind, id);
    return {bytes.begin(), bytes.end()};
}

// Writes a table with one step, whose arrays these bytes describe. Returns the table's facts.
TableFacts write_table(const std::filesystem::path& dataset, std::uint32_t arrays, std::span<const std::byte> step) {
    std::vector<std::byte> rows = head(FileKind::step_rows), all = head(FileKind::step_arrays);
    put(rows, 0.5);
    put(rows, std::array<std::uint32_t, 2>{0, 0});
    put(rows, std::uint64_t{all.size()});
    put(rows, std::array<std::uint32_t, 2>{static_cast<std::uint32_t>(step.size()), arrays});
    put(rows, checksum_number(step));
    all.insert(all.end(), step.begin(), step.end());
    write_file(dataset / "steps/rows", rows);
    write_file(dataset / "steps/arrays", all);
    return {1, checksum(std::span(rows).subspan(file_head_bytes)), {{"p", {0}}, {"U", {0}}, {"cell:p", {0}}}, {1}};
}

std::string text_of(const MarkedStep& step) { return to_text(Marker{1, {}, {step}}); }

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const test::Folder scratch;
    if (size < 1) return 0;
    const auto one = scratch / "one", other = scratch / "other";
    make_directory(one / "steps");
    try {
        const TableFacts facts = write_table(one, data[0], std::as_bytes(std::span(data + 1, size - 1)));
        const MarkedStep step = StepTable(one, facts, id).step(0);
        for (const auto& [name, array] : step.arrays)
            if (array.chunk == ~std::uint64_t{0}) return 0; // a further chunk would have no number
        const TableFacts written = append_to_table(other, {}, id, std::span(&step, 1));
        if (text_of(StepTable(other, written, id).step(0)) != text_of(step)) std::abort();
    } catch (const Error&) { // only Error is a valid refusal
    }
    return 0;
}
