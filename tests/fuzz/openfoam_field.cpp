// Fuzzes the parser of OpenFOAM's fields, with macros expanded.
#include "ciel/types.hpp"
#include "import/parsers/openfoam/field.hpp"
#include "import/parsers/openfoam/macros.hpp"

#include <cstdint>
#include <cstdlib>

using namespace server::importer;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const auto load = [](std::string_view name) -> std::optional<std::string> {
            if (name != "again") return std::nullopt;
            return "a 1;\n#include \"again\"\n";
        };
        constexpr std::size_t most = 1000;
        const std::string expanded = expand_foam_macros(std::string(text), "x", load);
        const FoamField field = parse_foam_field(expanded, "x", most);
        const auto width = static_cast<std::size_t>(field.components);
        if (field.cells.numbers.size() % width != 0) std::abort();
        static_cast<void>(field.condition("wall", {"solid"}));
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
