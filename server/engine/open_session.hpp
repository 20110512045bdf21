// A session with the geometry of its scene.
#pragma once

#include "engine/services.hpp"
#include "geometry/scene_geometry.hpp"
#include "sessions/session.hpp"

#include <atomic>
#include <memory>
#include <mutex>
#include <stop_token>
#include <string>

namespace ciel::engine {

// An OpenSession is thread-safe. All views and calls of the session share one geometry. Its unchanged parts are kept
// from one version to the next.
class OpenSession final : public sessions::Session {
public:
    // Drops `steps` beyond the history's limits.
    OpenSession(std::string id, const Services& services, std::shared_ptr<const sessions::SceneVersion> first,
                const sessions::Steps& steps = {});

    // Returns the geometry of `version`, made on the calling thread. Concurrent calls wait. Returns null when `stop`
    // was requested. `moving`, `layers_made`: see SceneGeometry::update. Throws Error, LimitReached.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(const sessions::SceneVersion& version,
                                                                     const std::stop_token& stop, bool moving = false,
                                                                     const geometry::LayersMade& layers_made = {});
    void release_geometry(); // frees the geometry of a session without viewers
    // Frees the geometry if the session has neither subscriber nor viewer, and has not been used since `unused_since`.
    // Does not wait: the geometry stays while another thread uses it.
    void release_idle_geometry(Clock::time_point unused_since);
    [[nodiscard]] std::size_t geometry_bytes() const { return surface_bytes_; } // query state and surfaces

private:
    void charge_surfaces(); // requires geometry_mutex_, as forget_surfaces() does; throws LimitReached
    void forget_surfaces();

    const Services& services_;
    std::mutex geometry_mutex_; // never locked while the session's own mutex is held
    geometry::SceneGeometry scene_geometry_;
    limits::Memory::Charge surfaces_;
    std::atomic<std::size_t> surface_bytes_{0}; // bytes charged to surfaces_; read without geometry_mutex_
};

} // namespace ciel::engine
