// Sizes of scene documents, for the limits on accepted and stored documents.
#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>

namespace server::scene {

// Returns the bytes of a document as JSON text without white space.
[[nodiscard]] std::size_t text_bytes(const nlohmann::json& document);

// Includes the overhead of the allocator. The recursion is as deep as the document (Limits::json_depth).
[[nodiscard]] std::size_t heap_bytes(const nlohmann::json& document);

} // namespace server::scene
