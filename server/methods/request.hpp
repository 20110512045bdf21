// Handles one parsed JSON-RPC request.
#pragma once

#include <exception>
#include <nlohmann/json.hpp>
#include <optional>

namespace server::methods {

struct CallContext; // methods/call_context.hpp

// Returns whether the request's method runs in the queue of slow calls (x-slow in the contract).
[[nodiscard]] bool is_slow(const nlohmann::json& request);

// Counts and logs an error that belongs to a text and not to one of its requests. Returns the answer to that text.
[[nodiscard]] nlohmann::json refuse_text(CallContext& context, nlohmann::json error);

// The turn of a request in the queue of slow calls.
struct Turn {
    double waited = 0;     // seconds in the queue before the first turn
    bool is_again = false; // the turn before has thrown AwaitsStep
};
// A late step that the method needs is being read from its source. Handle the request again in a moment.
class AwaitsStep : public std::exception {};

// Returns the answer; nothing for a notification. Throws only AwaitsStep, only for a slow method, and only within
// Limits::late_step_seconds of the first turn. Logs failures and slow calls.
[[nodiscard]] std::optional<nlohmann::json> handle(CallContext& context, const nlohmann::json& request, Turn turn = {});
// Returns the answer to a request that failed with the current exception. Returns nothing for a notification. Call it
// inside a catch block.
[[nodiscard]] std::optional<nlohmann::json> refuse(CallContext& context, const nlohmann::json& request);

} // namespace server::methods
