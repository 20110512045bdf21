// Sizes of scene documents, for the limits on accepted and stored documents.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace ciel::scene {

// Bytes of the document as JSON text without white space.
[[nodiscard]] std::size_t text_bytes(const nlohmann::json& document);

// Estimate of the heap bytes that the document holds, including the allocator's overhead. Recursion follows the
// document's depth, which Limits::json_depth bounds.
[[nodiscard]] std::size_t heap_bytes(const nlohmann::json& document);

} // namespace ciel::scene
