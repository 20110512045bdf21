#include "methods/scene_source.hpp"

namespace ciel::methods {

SceneSource::SceneSource(const Context& context, const std::optional<std::string>& session,
                         const std::optional<nlohmann::json>& scene)
    : context_(context) {
    if (session) session_ = context.session(*session);
    if (scene)
        version_ = session::make_version(context.server.services(), *scene, 0);
    else if (session_)
        version_ = session_->status().version;
    else
        throw InvalidParams("/session", "give a session, or a scene");
    if (scene) session_ = nullptr; // its own geometry: another scene would throw the session's away
}

std::shared_ptr<const session::Geometry> SceneSource::geometry() const {
    const std::stop_token& stop = context_.connection.stop;
    const session::Services& services = context_.server.services();
    auto made = session_ ? session_->geometry(*version_, stop)
                         : session::SceneGeometry(services.extraction)
                               .update(version_->scene, version_->loaded, stop, services.limits.session_memory_bytes);
    context_.check_wanted();
    return made;
}

} // namespace ciel::methods
