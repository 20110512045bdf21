// One JSON-RPC request, parsed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ciel::methods {

struct Context; // context.hpp

// Whether its method is queued: x-slow in the contract.
[[nodiscard]] bool is_slow(const nlohmann::json& request);

// The answer to a text that holds no request.
[[nodiscard]] nlohmann::json refuse_text(Context& context, nlohmann::json error);

// Calls the method and returns the answer, or nothing for a notification. Never throws for any input. Logs failures and
// slow calls. waited: seconds in the queue.
[[nodiscard]] std::optional<nlohmann::json> handle(Context& context, const nlohmann::json& request, double waited = 0);
// Returns the error answer for the current exception, or nothing for a notification. Call it inside a catch block.
[[nodiscard]] std::optional<nlohmann::json> refuse(Context& context, const nlohmann::json& request);

} // namespace ciel::methods
