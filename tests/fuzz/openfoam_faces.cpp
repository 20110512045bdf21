// Fuzzes the parser of OpenFOAM's faces.
#include "ciel/types.hpp"
#include "import/parsers/openfoam/poly_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

using namespace server::importer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const FoamFaces faces = parse_foam_faces(text, "x");
        if (faces.offset.front() != 0 || faces.offset.back() != faces.points.size() ||
            !std::is_sorted(faces.offset.begin(), faces.offset.end()))
            std::abort();
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
