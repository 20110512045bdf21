// Handles one parsed JSON-RPC request.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace server::methods {

struct CallContext; // methods/call_context.hpp

// Returns whether the request's method runs in the queue of slow calls (x-slow in the contract).
[[nodiscard]] bool is_slow(const nlohmann::json& request);

// Counts and logs an error that belongs to a text and not to one of its requests. Returns the answer to that text.
[[nodiscard]] nlohmann::json refuse_text(CallContext& context, nlohmann::json error);

// Returns nothing for a notification. Never throws. Logs failures and slow calls. `waited`: seconds in the queue.
[[nodiscard]] std::optional<nlohmann::json> handle(CallContext& context, const nlohmann::json& request,
                                                   double waited = 0);
// Answers the current exception. Returns nothing for a notification. Call it inside a catch block.
[[nodiscard]] std::optional<nlohmann::json> refuse(CallContext& context, const nlohmann::json& request);

} // namespace server::methods
