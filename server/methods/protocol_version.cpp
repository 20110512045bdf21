#include "methods/protocol_version.hpp"

#include "methods/error_answer.hpp"
#include "protocol/document.hpp"

namespace server::methods {

bool is_of_later_minor(const nlohmann::json& request) {
    const auto declared = request.find("protocol");
    if (declared == request.end()) return false;
    const auto number = [&](const char* name) -> std::int64_t {
        const auto member = declared->find(name);
        if (member == declared->end() || !member->is_number_unsigned())
            throw InvalidRequest(R"(protocol must be of the form {"major": 1, "minor": 0})");
        return member->get<std::int64_t>();
    };
    const std::int64_t major = number("major"), minor = number("minor");
    if (major != protocol::major_version)
        throw InvalidRequest("the request is of protocol version " + std::to_string(major) + "." +
                             std::to_string(minor) + "; this server has version " +
                             std::to_string(protocol::major_version) + "." + std::to_string(protocol::minor_version) +
                             "; use a client of major version " + std::to_string(protocol::major_version));
    return minor > protocol::minor_version;
}

} // namespace server::methods
