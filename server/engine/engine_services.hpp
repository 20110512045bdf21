// Process-wide objects that views and open sessions use. They are thread-safe and outlive all views and sessions.
#pragma once

#include "ciel/extract.hpp"
#include "engine/metrics.hpp"
#include "engine/schedule/frame_workers.hpp"
#include "limits/errors.hpp"
#include "limits/memory.hpp"
#include "sessions/session_services.hpp"

#include <functional>

namespace server::engine {

struct EngineServices : sessions::SessionServices {
    ciel::Extraction extraction;
    FrameWorkers& workers;
    Metrics& metrics;
    // Frees surfaces of unused sessions (Sessions::make_room), then unused fields, if little memory is left. Call it
    // without a lock.
    std::function<void()> make_room;

    // Makes room. Throws LimitReached if all memory is in use. Call it before surfaces or fields are made, because
    // their size is not known before.
    void require_room() const {
        make_room();
        if (memory.room() == 0) throw limits::LimitReached(memory.refusal());
    }
};

} // namespace server::engine
