#include "methods/cell_extremes.hpp"

namespace server::methods {
namespace {

protocol::CellExtreme extreme_of(const store::CellValue& found) {
    return {found.value, static_cast<std::int64_t>(found.cell), found.place, found.time};
}

} // namespace

std::optional<protocol::CellExtremes> answer_of(const std::optional<store::LowestAndHighest>& found) {
    if (!found) return {};
    return protocol::CellExtremes{extreme_of(found->lowest), extreme_of(found->highest)};
}

} // namespace server::methods
