// Checks Transfer-Encoding, which defines the end of the body of a request (RFC 9112, 6). If server and proxy disagreed
// about the end, a client could smuggle requests in a body.
#pragma once

#include <string_view>

namespace server::gateway {

enum class Framing {
    readable,       // chunked is the only coding
    malformed,      // chunked is repeated or not the last coding, so that the end of the body is unknown
    unknown_coding, // chunked after an unsupported coding
};

// `transfer_encoding`: all Transfer-Encoding lines of the request, at least one, joined by commas.
[[nodiscard]] Framing framing_of(std::string_view transfer_encoding);

} // namespace server::gateway
