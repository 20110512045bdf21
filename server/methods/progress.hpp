// Notifies clients of the progress of a long call, by the notification call.progress.
#pragma once

#include "methods/call_context.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace server::methods {

// Used by one thread at a time. A Progress without a name sends nothing.
class Progress {
public:
    // `name`, `session`: params of the call. A call on a WebSocket notifies its own connection. A call by POST notifies
    // the connections of `session`, if it is given. `context` must outlive this object. Throws NotFound.
    Progress(const CallContext& context, std::optional<std::string> name, const std::optional<std::string>& session);

    void begin(const char* stage); // one of the stages of call.progress in the contract
    // Notifies clients that `done` of `of` items of the stage are done, at most five times a second.
    void count(const char* stage, std::size_t done, std::size_t of);

private:
    void tell(const char* stage, std::size_t done, std::size_t of) const;

    const CallContext& context_;
    const std::optional<std::string> name_;
    const std::shared_ptr<const engine::OpenSession> session_;
    std::chrono::steady_clock::time_point told_{};
};

} // namespace server::methods
