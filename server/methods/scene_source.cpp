#include "methods/scene_source.hpp"

namespace server::methods {

SceneSource::SceneSource(const CallContext& context, const std::optional<std::string>& session,
                         const std::optional<nlohmann::json>& scene)
    : context_(context), surfaces_(context.server.memory(), limits::Held::surfaces) {
    if (session) session_ = context.session(*session);
    if (scene)
        version_ = sessions::accept_scene(context.server.services(), *scene, 0, context.request_id);
    else if (session_)
        version_ = session_->status().version;
    else
        throw InvalidParams("/session", "give a session or a scene");
    if (scene) session_ = nullptr; // a given scene gets its own geometry, and the session's geometry is kept
}

std::shared_ptr<const geometry::Geometry> SceneSource::geometry(Progress& progress) {
    const auto layers_made = [&](std::size_t done, std::size_t of) { progress.count("surfaces", done, of); };
    auto made =
        session_ ? session_->geometry(*version_, context_.stop, false, layers_made) : geometry_of_scene(layers_made);
    context_.check_wanted();
    return made;
}

std::shared_ptr<const geometry::Geometry> SceneSource::geometry_of_scene(const geometry::LayersMade& layers_made) {
    const engine::EngineServices& services = context_.server.services();
    services.require_room();
    const std::uint64_t own = services.limits.session_memory_bytes, left = services.memory.room();
    try {
        geometry::SceneGeometry geometry(services.extraction);
        auto made = geometry.update(version_->checked, context_.stop, std::min(own, left), false, layers_made);
        surfaces_.change(geometry.memory_bytes());
        return made;
    } catch (const limits::LimitReached&) {
        if (left >= own) throw;
        throw limits::LimitReached(services.memory.refusal());
    }
}

} // namespace server::methods
