#include "gateway/framing.hpp"

#include "gateway/header_text.hpp"

namespace server::gateway {
namespace {

bool is_chunked(std::string_view coding) { return same_ignoring_case(coding, "chunked"); }

} // namespace

Framing framing_of(std::string_view transfer_encoding) {
    const std::string_view all = trimmed(transfer_encoding);
    if (is_chunked(all)) return Framing::readable;
    const auto comma = all.rfind(',');
    if (comma == std::string_view::npos || !is_chunked(trimmed(all.substr(comma + 1)))) return Framing::malformed;
    for (std::string_view rest = all.substr(0, comma);;) {
        const auto coding = trimmed(rest.substr(0, rest.find(',')));
        if (coding.empty() || is_chunked(coding)) return Framing::malformed;
        const auto next = rest.find(',');
        if (next == std::string_view::npos) return Framing::unknown_coding;
        rest.remove_prefix(next + 1);
    }
}

} // namespace server::gateway
