// What sessions and views use of the server; all of it outlives them and is thread-safe.
#pragma once

#include "ciel/extract.hpp"
#include "session/connections.hpp"
#include "session/frame_workers.hpp"
#include "session/limits.hpp"
#include "session/memory.hpp"
#include "session/metrics.hpp"
#include "store/catalog.hpp"

namespace ciel::session {

struct Services {
    const Limits& limits;
    Extraction extraction;
    store::Catalog& catalog;
    Connections& connections;
    FrameWorkers& workers;
    Metrics& metrics;
    Memory& memory;
};

} // namespace ciel::session
