#include "methods/scene_source.hpp"

namespace ciel::methods {

SceneSource::SceneSource(const Context& context, const std::optional<std::string>& session,
                         const std::optional<nlohmann::json>& scene)
    : services_(context.server.services()) {
    if (session) session_ = context.session(*session);
    if (scene)
        version_ = session::make_version(services_, *scene, 0);
    else if (session_)
        version_ = session_->status().version;
    else
        throw InvalidParams("/session", "give a session, or a scene");
    if (scene) session_ = nullptr; // its own geometry: another scene would throw the session's away
}

std::shared_ptr<const session::Geometry> SceneSource::geometry() const {
    auto made = session_ ? session_->geometry(*version_, {})
                         : session::SceneGeometry(services_.engine).update(version_->scene, version_->loaded);
    session::require_complete(*made);
    return made;
}

} // namespace ciel::methods
