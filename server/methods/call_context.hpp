// The objects that a method may use, and the exceptions of methods.
#pragma once

#include "engine/engine_services.hpp"
#include "engine/server.hpp"
#include "engine/sessions.hpp"
#include "limits/errors.hpp"
#include "methods/cancellation.hpp"
#include "protocol/methods.hpp"

#include <chrono>

namespace server::methods {

// Throws NotAllowed unless the server accepts appended steps and the connection has the server's token.
void check_may_append(const engine::Server& server, const sessions::Connection& connection);

struct CallContext { // NOLINT(bugprone-exception-escape): moving a string does not throw
    engine::Server& server;
    sessions::Connection& connection;
    std::stop_token stop{};   // requested when the connection has ended or the server cancels the call
    std::string request_id{}; // id of the call in progress, for the log and for errors
    std::chrono::steady_clock::time_point begun{};
    // Counts the memory of the result of the call in progress, until the memory of the answer's text is counted
    // instead.
    limits::Memory::Charge making{server.memory(), limits::Held::answers};

    void begin();                              // starts a call: sets its id and time
    [[nodiscard]] double milliseconds() const; // since begin()
    [[nodiscard]] engine::Caller caller() const { return {connection, request_id}; }
    [[nodiscard]] sessions::Author author() const { return {connection.id, request_id}; }

    [[nodiscard]] std::shared_ptr<engine::OpenSession> session(const std::string& id) const {
        return server.sessions().find(id);
    }
    void check_wanted() const { methods::check_wanted(connection.stop, stop); }
    void check_may_append() const { methods::check_may_append(server, connection); }
    [[nodiscard]] std::shared_ptr<engine::View> view(std::int64_t id) const;
    [[nodiscard]] std::shared_ptr<store::LoadedDataset> dataset(const std::string& name) const;
    // Views and subscriptions keep this pointer. Returns null over HTTP, which has no frames.
    [[nodiscard]] std::shared_ptr<sessions::Connection> streaming_connection() const;
};

// Thrown for params that violate the schema or a rule of the method. `path` is a JSON pointer into the params.
class InvalidParams : public std::runtime_error {
public:
    InvalidParams(std::string path_, const std::string& reason) : std::runtime_error(reason), path(std::move(path_)) {}
    std::string path;
};
class NeedsWebSocket : public std::runtime_error {
public:
    using std::runtime_error::runtime_error;
};

[[nodiscard]] protocol::SessionState state_of(const sessions::Session& session, const sessions::SessionStatus& status);

} // namespace server::methods
