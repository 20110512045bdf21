// JSON text of clients.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string_view>

namespace server::scene {

// Thrown if a JSON object has two members of the same name. RFC 8259, section 4, lets a parser drop one of them, so
// that a layer could be lost silently.
struct TwiceNamed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws TwiceNamed, which names the member, and the exceptions of nlohmann::json::parse. Thread-safe.
[[nodiscard]] nlohmann::json read_json(std::string_view text);

} // namespace server::scene
