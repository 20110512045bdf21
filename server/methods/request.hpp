// One JSON-RPC request, parsed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ciel::methods {

struct Context; // context.hpp

// Its method waits for its turn: x-slow in the contract.
[[nodiscard]] bool is_slow(const nlohmann::json& request);

// Does what is asked and answers; nothing when there is nothing to be answered. Never throws for any input.
[[nodiscard]] std::optional<nlohmann::json> handle(Context& context, const nlohmann::json& request);
// The answer to one that is not handled for the reason that is the current exception; to be called in a handler.
[[nodiscard]] std::optional<nlohmann::json> refuse(Context& context, const nlohmann::json& request);

} // namespace ciel::methods
