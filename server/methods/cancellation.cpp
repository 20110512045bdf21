#include "methods/cancellation.hpp"

#include "ciel/types.hpp"

namespace server::methods {

void check_wanted(const std::stop_token& connection_ended, const std::stop_token& stop) {
    if (connection_ended.stop_requested())
        throw ciel::Error(
            "the connection ended before the answer; keep the connection open until the answer has arrived");
    if (stop.stop_requested())
        throw ciel::Error("the server is about to stop and has cancelled the call; try again after its restart");
}

} // namespace server::methods
