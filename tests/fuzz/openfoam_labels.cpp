// Fuzzes the parser of OpenFOAM's owners, neighbors and addressing.
#include "ciel/types.hpp"
#include "import/parsers/openfoam/poly_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

using namespace server::importer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        constexpr std::size_t most = 1000;
        if (parse_foam_labels(text, "x", most).size() > std::max(most, size)) std::abort();
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
