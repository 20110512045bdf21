// Macros of OpenFOAM's text files: $NAME for what an entry before it holds, and #include (OpenFOAM User Guide,
// "Directives and macro substitutions"). Solvers write none; files that people write are full of them.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace ciel::importer {

// The text of an included file; nullopt where there is none.
using LoadIncluded = std::function<std::optional<std::string>(std::string_view name)>;

// `text` with its macros replaced; the text itself where it has none or is binary. #includeEtc, which only sets what
// the mesh says itself, is passed over. Throws Error naming `file` where a name is not known, where includes are nested
// more than 16 deep, and for what OpenFOAM alone can evaluate (#calc, #codeStream).
[[nodiscard]] std::string expand_foam_macros(std::string text, const std::string& file, const LoadIncluded& load);

} // namespace ciel::importer
