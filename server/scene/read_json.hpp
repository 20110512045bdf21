// A JSON text (RFC 8259) that somebody wrote by hand.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <stdexcept>
#include <string_view>

namespace ciel::scene {

// One object has two members of one name: RFC 8259, section 4 lets a parser choose one of them, and the other layer
// would be gone without a word.
struct TwiceNamed : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// Throws TwiceNamed, a sentence that names the member, and what nlohmann::json::parse throws. Thread-safe.
[[nodiscard]] nlohmann::json read_json(std::string_view text);

} // namespace ciel::scene
