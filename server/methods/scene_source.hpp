// The scene of a picture, probe or export: a session's, or one given in the call.
#pragma once

#include "methods/call_context.hpp"

#include <optional>

namespace ciel::methods {

class SceneSource {
public:
    // Takes the given scene, or else the session's. Throws InvalidParams when there is neither, scene::Invalid,
    // NotFound. Borrows `context`.
    SceneSource(const CallContext& context, const std::optional<std::string>& session,
                const std::optional<nlohmann::json>& scene);

    [[nodiscard]] const sessions::SceneVersion& version() const { return *version_; }
    // Returns the geometry of the scene. A session's geometry is shared with its views. The geometry of a given scene
    // is made for this call, and its memory is counted as long as the SceneSource lives. `layers_made`: see
    // SceneGeometry. Throws LimitReached, and Error if the connection ends meanwhile.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(const geometry::LayersMade& layers_made = {});

private:
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry_of_scene(const geometry::LayersMade& layers_made);

    const CallContext& context_;
    std::shared_ptr<engine::OpenSession> session_;
    std::shared_ptr<const sessions::SceneVersion> version_;
    limits::Memory::Charge surfaces_;
};

} // namespace ciel::methods
