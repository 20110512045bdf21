// Fuzzes the parser of /proc/net/tcp and tcp6.
#include "gateway/peer_owner.hpp"

#include <cstdlib>
#include <sstream>

using namespace server::gateway;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string text(reinterpret_cast<const char*>(data), size);
    const std::string peer = "0100007F:D431", own = "0100007F:1F90";
    std::istringstream lines(text), table(text);
    bool any_of_root = false;
    for (std::string line; std::getline(lines, line);) {
        const auto row = parse_socket_row(line);
        if (!row) continue;
        if (line.find(row->local) == std::string::npos || line.find(row->remote) == std::string::npos) std::abort();
        any_of_root = any_of_root || (row->local == peer && row->remote == own && row->state == 1 && row->user == 0 &&
                                      row->inode != 0);
    }
    if (sockets_of(table, 0).contains(peer + " " + own) && !any_of_root) std::abort();
    return 0;
}
