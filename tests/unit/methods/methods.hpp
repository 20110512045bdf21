// A server with a session over the small dataset, and expected values for tests of its methods.
#pragma once

#include "service.hpp"

#include <cstdint>
#include <stdexcept>
#include <string>

namespace ciel::test {
using namespace server;

class Methods : public Service {
protected:
    engine::Server server{options()};
    Client client{server, true};
    std::string session = client.call("session.open", {{"scene", scene_with_iso()}})["session"];
    json in_session(json params) {
        params["session"] = session;
        return params;
    }
};

inline const json colored_scene = json::parse(
    R"({"dataset": "box", "layers": {"iso": {"type": "iso", "array": "p", "values": [12], "color": {"array": "U:x"}}}})");

// Decodes base64.
inline std::string decoded(const std::string& text) {
    static const std::string alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    std::uint32_t bits = 0;
    int count = 0;
    for (const char c : text) {
        if (c == '=') break;
        const std::size_t digit = alphabet.find(c);
        if (digit == std::string::npos) throw std::runtime_error("not base64: " + text.substr(0, 100));
        bits = bits << 6 | static_cast<std::uint32_t>(digit);
        if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
    }
    return bytes;
}

} // namespace ciel::test
