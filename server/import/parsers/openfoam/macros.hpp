// Expands macros in OpenFOAM's text files. $NAME becomes the value of an earlier entry. #include becomes the text of
// another file (OpenFOAM User Guide, "Directives and macro substitutions"). Files written by hand may use macros.
// Solvers do not write macros.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ciel::importer {

// Returns the text of the included file `name`; nullopt if there is no such file.
using LoadIncluded = std::function<std::optional<std::string>(std::string_view name)>;

// Returns `text` with all macros expanded. Returns `text` unchanged if it has no macros or is binary. Ignores
// #includeEtc, #inputMode and #remove. Throws Error for an unknown macro, a missing #include file, includes nested more
// than 16 deep, and directives that only OpenFOAM can evaluate (#calc, #codeStream). Error texts start with `file`.
[[nodiscard]] std::string expand_foam_macros(std::string text, const std::string& file, const LoadIncluded& load);

} // namespace ciel::importer
