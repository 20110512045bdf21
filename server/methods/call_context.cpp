#include "methods/call_context.hpp"

#include "logging/log.hpp"
#include "sessions/open_dataset.hpp"

namespace server::methods {

void CallContext::begin() {
    request_id = connection.request.empty() ? logging::next_request_id() : connection.request;
    begun = std::chrono::steady_clock::now();
}

double CallContext::milliseconds() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
}

std::shared_ptr<store::LoadedDataset> CallContext::dataset(const std::string& name) const {
    return sessions::open_dataset(server.catalog(), name);
}

void check_may_append(const engine::Server& server, const sessions::Connection& connection) {
    if (!server.options().allow_append)
        throw limits::NotAllowed(
            "this server does not accept steps; start the server with `ciel serve --allow-append`");
    if (!connection.has_token)
        throw limits::NotAllowed("appending needs the token of the server; send the token with every request: "
                                 "\"Authorization: Bearer TOKEN\"");
}

std::shared_ptr<engine::View> CallContext::view(std::int64_t id) const {
    const bool possible = id > 0 && id <= UINT32_MAX;
    return server.sessions().view(possible ? static_cast<std::uint32_t>(id) : 0, connection.id);
}

std::shared_ptr<sessions::Connection> CallContext::streaming_connection() const {
    return connection.is_streaming() ? server.services().connections.find(connection.id) : nullptr;
}

protocol::SessionState state_of(const sessions::Session& session, const sessions::SessionStatus& status) {
    return {session.id(), static_cast<std::int64_t>(status.version->revision), *status.version->document,
            status.can_undo, status.can_redo};
}

} // namespace server::methods
