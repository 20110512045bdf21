// JSON-RPC notifications.
#pragma once

#include "protocol/json.hpp"

#include <string>

namespace server::sessions {

// Returns a notification as JSON-RPC text. `Note`: one of the contract's notification structures.
template <class Note>
std::string notification_text(const Note& note) {
    const nlohmann::json text{{"jsonrpc", "2.0"}, {"method", Note::method}, {"params", note}};
    return text.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

} // namespace server::sessions
