// Fuzzes check_legacy_vtk_counts. It must refuse any text content that is followed by an excess count, so it skips no
// word.
#include "import/parsers/legacy_vtk_counts.hpp"
#include "ciel/types.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>

namespace {

bool accepts(const std::string& content) {
    std::istringstream file(content);
    try {
        server::importer::check_legacy_vtk_counts(file, content.size(), "x");
        return true;
    } catch (const ciel::Error&) { // the parser may refuse the input
        return false;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string content(reinterpret_cast<const char*>(data), size);
    (void)accepts(content);
    if (accepts("# vtk DataFile Version 3.0\n\nASCII\n" + content + "\nPOINTS 99999999999999999999 float\n"))
        std::abort();
    return 0;
}
