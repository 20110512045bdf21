// Fuzzes the detection of PLOT3D layouts. Bytes 0 to 3 give the size of the file, the rest is its beginning.
#include "import/parsers/plot3d_layout.hpp"
#include "ciel/types.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>

using namespace server::importer;

namespace {

void check(const std::vector<Plot3dLayout>& layouts, std::uint64_t size) {
    for (const Plot3dLayout& layout : layouts) {
        std::uint64_t points = 0;
        for (std::size_t grid = 0; grid < layout.dims.size(); ++grid) points += layout.points(grid);
        if (layout.dims.empty() || points == 0 || points > size || !plot3d_match(layout, layout)) std::abort();
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::uint32_t claimed = 0;
    if (size < sizeof claimed) return 0;
    std::memcpy(&claimed, data, sizeof claimed);
    const std::span<const std::byte> head(reinterpret_cast<const std::byte*>(data) + 4, size - 4);
    const std::string_view text(reinterpret_cast<const char*>(data) + 4, size - 4);
    for (const Plot3dKind kind : {Plot3dKind::grid, Plot3dKind::solution}) {
        check(plot3d_binary_layouts(head, claimed, kind), claimed);
        check(plot3d_binary_layouts(head, head.size(), kind), head.size());
        check(plot3d_text_layouts(text, claimed, kind), claimed);
    }
    try {
        (void)plot3d_restrict({Plot3dLayout{}}, std::string(text));
    } catch (const ciel::Error&) { // the text contains an unknown word
    }
    return 0;
}
