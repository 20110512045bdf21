// Tells clients how far a long call is, by the notification call.progress.
#pragma once

#include "methods/context.hpp"

#include <chrono>
#include <optional>
#include <string>

namespace ciel::methods {

// Used by one thread at a time. A Progress without a name tells nothing.
class Progress {
public:
    // `name`: the call's parameter. `session`: the call's parameter; its connections are told where the call came by
    // POST. Borrows `context`. Throws NotFound.
    Progress(const Context& context, std::optional<std::string> name, const std::optional<std::string>& session);

    void begin(const char* stage); // one of the contract's
    // Tells how many layers are made, at most five times a second.
    void layers(std::size_t done, std::size_t of);

private:
    void tell(const char* stage, std::size_t done, std::size_t of) const;

    const Context& context_;
    const std::optional<std::string> name_;
    const std::shared_ptr<const engine::OpenSession> session_;
    std::chrono::steady_clock::time_point told_{};
};

} // namespace ciel::methods
