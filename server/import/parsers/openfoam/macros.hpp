// Expands macros in OpenFOAM's text files: $NAME, the value of an earlier entry, and #include (OpenFOAM User Guide,
// "Directives and macro substitutions"). Files written by hand use macros; files written by solvers do not.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ciel::importer {

// Returns the text of the included file `name`; nullopt if there is no such file.
using LoadIncluded = std::function<std::optional<std::string>(std::string_view name)>;

// Returns `text` with macros expanded; unchanged if it has none or is binary. Ignores #includeEtc, #inputMode and
// #remove. Throws Error naming `file` for an unknown macro, a missing #include file, includes nested more than 16 deep,
// and directives that only OpenFOAM can evaluate (#calc, #codeStream).
[[nodiscard]] std::string expand_foam_macros(std::string text, const std::string& file, const LoadIncluded& load);

} // namespace ciel::importer
