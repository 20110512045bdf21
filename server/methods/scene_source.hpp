// The scene of a picture, probe or export: the scene of a session, or a scene in the call.
#pragma once

#include "methods/call_context.hpp"

#include <optional>

namespace ciel::methods {

class SceneSource {
public:
    // Uses `scene` if it is given, else the scene of the session. Throws InvalidParams if neither is given,
    // scene::Invalid, NotFound. Does not own `context`, which must outlive this object.
    SceneSource(const CallContext& context, const std::optional<std::string>& session,
                const std::optional<nlohmann::json>& scene);

    [[nodiscard]] const sessions::SceneVersion& version() const { return *version_; }
    // Returns the geometry of the scene. The geometry of a session is shared with the views of the session. The
    // geometry of a given scene is made for this call, and its memory is counted until the SceneSource is destroyed.
    // `layers_made`: see SceneGeometry. Throws LimitReached, and Error if the connection ends during the call.
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry(const geometry::LayersMade& layers_made = {});

private:
    [[nodiscard]] std::shared_ptr<const geometry::Geometry> geometry_of_scene(const geometry::LayersMade& layers_made);

    const CallContext& context_;
    std::shared_ptr<engine::OpenSession> session_;
    std::shared_ptr<const sessions::SceneVersion> version_;
    limits::Memory::Charge surfaces_;
};

} // namespace ciel::methods
