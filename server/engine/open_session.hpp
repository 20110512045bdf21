// A session with the geometry that it shows.
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

// Thread-safe. Its views and the calls about it share one geometry, which is kept from one version to the next.
class OpenSession final : public sessions::Session {
public:
    // Steps beyond the limits are left out.
    OpenSession(std::string id, const Services& services, std::shared_ptr<const sessions::SceneVersion> first,
                const sessions::Steps& steps = {});

    // Made on the calling thread; others wait. Null when stopped. `moving`: as SceneGeometry::update has it. Throws
    // Error, LimitReached.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(const sessions::SceneVersion& version,
                                                                     const std::stop_token& stop, bool moving = false);
    void release_geometry(); // the memory of a session without viewers
    [[nodiscard]] std::size_t geometry_bytes() const { return surface_bytes_; } // query state and surfaces

private:
    void charge_surfaces(); // REQUIRES the lock, as the next one does. Throws LimitReached.
    void forget_surfaces();

    const Services& services_;
    std::mutex geometry_mutex_; // taken without the session's lock only
    geometry::SceneGeometry scene_geometry_;
    limits::Memory::Charge surfaces_;
    std::atomic<std::size_t> surface_bytes_{0}; // as charged: read without the lock
};

} // namespace ciel::engine
