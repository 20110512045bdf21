// Pictures, probes and exports work on a session's scene or on one given in place.
#pragma once

#include "methods/context.hpp"

#include <optional>

namespace ciel::methods {

class SceneSource {
public:
    // Throws InvalidParams when there is neither a session nor a scene; scene::Invalid, NotFound.
    SceneSource(const Context& context, const std::optional<std::string>& session,
                const std::optional<nlohmann::json>& scene);

    [[nodiscard]] const sessions::SceneVersion& version() const { return *version_; }
    // A session's geometry is kept and shared with its views; without a session it is made for this call, and counted
    // as long as this object lives. Throws LimitReached, and Error when the connection ends meanwhile.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry();

private:
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry_of_scene();

    const Context& context_;
    std::shared_ptr<engine::OpenSession> session_;
    std::shared_ptr<const sessions::SceneVersion> version_;
    limits::Memory::Charge surfaces_;
};

} // namespace ciel::methods
