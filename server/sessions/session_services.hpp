// Process-wide objects that sessions use. They are thread-safe and outlive all sessions.
#pragma once

#include "limits/limits.hpp"
#include "limits/memory.hpp"
#include "sessions/open_connections.hpp"
#include "store/catalog.hpp"

namespace server::sessions {

struct SessionServices {
    const limits::Limits& limits;
    store::Catalog& catalog;
    OpenConnections& connections;
    limits::Memory& memory;
};

} // namespace server::sessions
