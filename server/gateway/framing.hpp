// Where a request's body ends (RFC 9112, 6): a server and a proxy that disagree let a request hide in another's body.
#pragma once

#include <string_view>

namespace ciel::gateway {

enum class Framing {
    readable,       // chunked alone
    malformed,      // chunked is not the last coding, or stands twice: where the body ends is not known
    unknown_coding, // chunked after a coding that this server does not have
};

// Of a request that has a Transfer-Encoding: all its lines, joined by commas.
[[nodiscard]] Framing framing_of(std::string_view transfer_encoding);

} // namespace ciel::gateway
