// The scene of a picture, probe or export: the scene of a session, or a scene in the call.
#pragma once

#include "methods/progress.hpp"

#include <optional>

namespace server::methods {

class SceneSource {
public:
    // Prefers `scene`. Throws InvalidParams if neither is given, scene::Invalid, NotFound. `context` must outlive this.
    SceneSource(const CallContext& context, const std::optional<std::string>& session,
                const std::optional<nlohmann::json>& scene);

    [[nodiscard]] const sessions::SceneVersion& version() const { return *version_; }
    // Views of a session share its geometry. The memory of the geometry of a given scene is counted until the
    // SceneSource is destroyed. Reports the stage "surfaces" to `progress`. Throws LimitReached, and Error if the
    // connection ends.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(Progress& progress);

private:
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry_of_scene(const geometry::LayersMade& layers_made);

    const CallContext& context_;
    std::shared_ptr<engine::OpenSession> session_;
    std::shared_ptr<const sessions::SceneVersion> version_;
    limits::Memory::Charge surfaces_;
};

} // namespace server::methods
