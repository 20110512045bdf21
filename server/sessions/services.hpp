// What sessions use of the process; all of it outlives them and is thread-safe.
#pragma once

#include "limits/limits.hpp"
#include "limits/memory.hpp"
#include "sessions/connections.hpp"
#include "store/catalog.hpp"

namespace ciel::sessions {

struct Services {
    const limits::Limits& limits;
    store::Catalog& catalog;
    Connections& connections;
    limits::Memory& memory;
};

} // namespace ciel::sessions
