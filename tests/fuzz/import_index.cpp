// Fuzzes three parsers, selected by the first byte: PVD collections, file series, dimensions of OpenFOAM fields.
#include "ciel/types.hpp"
#include "import/parsers/index_entry.hpp"
#include "import/parsers/openfoam/units.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace {

void check(const std::vector<server::importer::IndexEntry>& entries) {
    const bool sound = !entries.empty() && std::all_of(entries.begin(), entries.end(), [](const auto& entry) {
        return !entry.file.empty() && std::isfinite(entry.time);
    });
    const bool sorted =
        std::is_sorted(entries.begin(), entries.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
    if (!sound || !sorted) std::abort();
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string_view text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        if (data[0] % 3 == 0) check(server::importer::parse_pvd(text, "x"));
        if (data[0] % 3 == 1) check(server::importer::parse_series(text, "x"));
        if (data[0] % 3 == 2 && server::importer::openfoam_units(text).size() > 200) std::abort();
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
