// Converts the lowest and the highest cell value of an array to the form of an answer.
#pragma once

#include "methods/call_context.hpp"
#include "store/cell_extremes.hpp"

namespace server::methods {

[[nodiscard]] std::optional<protocol::CellExtremes> answer_of(const std::optional<store::LowestAndHighest>& found);

} // namespace server::methods
