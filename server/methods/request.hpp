// One JSON-RPC request, parsed.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>

namespace ciel::methods {

struct Context; // context.hpp

// Its method waits for its turn: x-slow in the contract.
[[nodiscard]] bool is_slow(const nlohmann::json& request);

// The answer to a text that holds no request.
[[nodiscard]] nlohmann::json refuse_text(Context& context, nlohmann::json error);

// Does what is asked and answers; nothing when there is nothing to be answered. Never throws for any input. Failures
// and slow calls are logged. waited: seconds until its turn came.
[[nodiscard]] std::optional<nlohmann::json> handle(Context& context, const nlohmann::json& request, double waited = 0);
// The answer to one that is not handled for the reason that is the current exception; to be called in a handler.
[[nodiscard]] std::optional<nlohmann::json> refuse(Context& context, const nlohmann::json& request);

} // namespace ciel::methods
