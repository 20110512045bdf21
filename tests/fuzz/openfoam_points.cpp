// Fuzzes the parser of OpenFOAM's points.
#include "ciel/types.hpp"
#include "import/parsers/openfoam/poly_mesh.hpp"

#include <cstdint>
#include <cstdlib>

using namespace server::importer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        if (parse_foam_points(text, "x").size() % 3 != 0) std::abort();
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
