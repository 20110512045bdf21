// Expands macros in OpenFOAM's text files: $NAME and #include (OpenFOAM User Guide, "Directives and macro
// substitutions"). Files written by hand may use macros. Solvers do not write macros.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace server::importer {

// Returns the text of an included file; nullopt if there is no such file.
using LoadIncluded = std::function<std::optional<std::string>(std::string_view name)>;

// Returns `text` with all macros expanded. Ignores #includeEtc, #inputMode and #remove. Throws Error for an unknown
// macro, a missing #include file, includes nested more than 16 deep, and directives that only OpenFOAM can evaluate
// (#calc, #codeStream).
[[nodiscard]] std::string expand_foam_macros(std::string text, const std::string& file, const LoadIncluded& load);

} // namespace server::importer
