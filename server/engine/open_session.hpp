// A session with the geometry of its scene.
#pragma once

#include "engine/engine_services.hpp"
#include "geometry/scene_geometry.hpp"
#include "sessions/session.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace server::engine {

// Thread-safe. All views and calls share one geometry. A new version makes only the changed layers again.
class OpenSession final : public sessions::Session {
public:
    struct LoggedCall {
        std::string user, remote, request; // name for logs, address, id of the call; empty: not known
    };
    // `steps`: undo and redo steps of the session. Steps beyond the limits of the history are dropped.
    OpenSession(std::string id, const EngineServices& services, std::shared_ptr<const sessions::SceneVersion> first,
                LoggedCall opener, const sessions::UndoRedoSteps& steps = {});

    [[nodiscard]] const LoggedCall& opener() const { return opener_; }

    // Makes the geometry on the calling thread. Concurrent calls run one after another. Returns null if `stop` was
    // requested. `moving`, `layers_made`: see SceneGeometry::update. Throws Error, LimitReached.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(const sessions::SceneVersion& version,
                                                                     const std::stop_token& stop, bool moving = false,
                                                                     const geometry::LayersMade& layers_made = {});
    void release_geometry(); // frees the geometry; call if the session has no viewer and no subscriber
    // Frees the geometry, unless the session has a subscriber or viewer or was used since `unused_since`, or another
    // thread uses the geometry.
    void release_idle_geometry(Clock::time_point unused_since);
    [[nodiscard]] std::size_t geometry_bytes() const { return surface_bytes_; } // bytes of query state and surfaces

private:
    void charge_surfaces(); // requires geometry_mutex_ to be held; throws LimitReached
    void forget_surfaces(); // requires geometry_mutex_ to be held

    const EngineServices& services_;
    const LoggedCall opener_;
    std::mutex geometry_mutex_; // never locked while the session's own mutex is held
    geometry::SceneGeometry scene_geometry_;
    limits::Memory::Charge surfaces_;
    std::atomic<std::size_t> surface_bytes_{0}; // bytes charged to surfaces_; read without geometry_mutex_
};

} // namespace server::engine
