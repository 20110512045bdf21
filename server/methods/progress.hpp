// Tells clients how far a long call is, by the notification call.progress.
#pragma once

#include "methods/call_context.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace ciel::methods {

// Used by one thread at a time. A Progress without a name sends nothing.
class Progress {
public:
    // `name`: the call's parameter `progress`, which the notifications repeat. `session`: the call's parameter; if the
    // call came by POST, the connections of this session are notified, or none without a session. Borrows `context`.
    // Throws NotFound.
    Progress(const CallContext& context, std::optional<std::string> name, const std::optional<std::string>& session);

    void begin(const char* stage); // one of the stages of call.progress in the contract
    // Sends that `done` of `of` parts of the stage are done, at most five times a second.
    void count(const char* stage, std::size_t done, std::size_t of);

private:
    void tell(const char* stage, std::size_t done, std::size_t of) const;

    const CallContext& context_;
    const std::optional<std::string> name_;
    const std::shared_ptr<const engine::OpenSession> session_;
    std::chrono::steady_clock::time_point told_{};
};

} // namespace ciel::methods
