#include "engine/open_session.hpp"

#include "limits/errors.hpp"

#include <algorithm>

namespace server::engine {

OpenSession::OpenSession(std::string id, const EngineServices& services,
                         std::shared_ptr<const sessions::SceneVersion> first, LoggedCall opener,
                         const sessions::UndoRedoSteps& steps)
    : Session(std::move(id), services, std::move(first), steps), services_(services), opener_(std::move(opener)),
      scene_geometry_(services.extraction), surfaces_(services.memory, limits::Held::surfaces) {}

std::shared_ptr<const geometry::Geometry> OpenSession::geometry(const sessions::SceneVersion& version,
                                                                const std::stop_token& stop, bool moving,
                                                                const geometry::LayersMade& layers_made) {
    services_.require_room();
    const std::scoped_lock lock(geometry_mutex_);
    const std::uint64_t own = services_.limits.session_memory_bytes;
    const std::uint64_t left = surfaces_.bytes() + services_.memory.room();
    try {
        auto made = scene_geometry_.update(version.checked, stop, std::min(own, left), moving, layers_made);
        charge_surfaces();
        return made;
    } catch (const limits::LimitReached&) {
        forget_surfaces();
        if (left >= own) throw;
        throw limits::LimitReached(services_.memory.refusal());
    }
}

void OpenSession::charge_surfaces() {
    surface_bytes_ = scene_geometry_.memory_bytes();
    surfaces_.change(surface_bytes_);
}

void OpenSession::forget_surfaces() {
    scene_geometry_ = geometry::SceneGeometry(services_.extraction);
    charge_surfaces();
}

void OpenSession::release_geometry() {
    const std::scoped_lock lock(geometry_mutex_);
    forget_surfaces();
}

void OpenSession::release_idle_geometry(Clock::time_point unused_since) {
    const std::unique_lock lock(geometry_mutex_, std::try_to_lock);
    if (lock && surface_bytes_ > 0 && is_idle_since(unused_since)) forget_surfaces();
}

} // namespace server::engine
