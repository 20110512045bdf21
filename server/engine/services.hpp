// What views and open sessions use of the process; all of it outlives them and is thread-safe.
#pragma once

#include "ciel/extract.hpp"
#include "engine/metrics.hpp"
#include "engine/schedule/frame_workers.hpp"
#include "sessions/services.hpp"

namespace ciel::engine {

struct Services : sessions::Services {
    Extraction extraction;
    FrameWorkers& workers;
    Metrics& metrics;
};

} // namespace ciel::engine
