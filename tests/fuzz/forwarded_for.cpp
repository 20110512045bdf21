// Fuzzes X-Forwarded-For and the ranges of trusted proxies, one per line.
#include "ciel/types.hpp"
#include "gateway/remote_address.hpp"

#include <cstdlib>

using namespace ciel;
using namespace server::gateway;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string header = text.substr(0, text.find('\n'));
    const std::string range = text.substr(std::min(header.size() + 1, text.size()));
    const auto client = last_forwarded_for(header);
    if (client && client->is_v6() && client->to_v6().is_v4_mapped()) std::abort();
    if (client && counting_key(*client).empty() != client->is_loopback()) std::abort();
    try {
        const TrustedProxies proxies({range});
        if (client && range == client->to_string() && !proxies.contains(*client)) std::abort();
    } catch (const Error&) { // the parser may refuse the input
    }
    return 0;
}
