#include "geometry/default_scene.hpp"
#include "methods/call_context.hpp"

namespace server::methods {
namespace {

std::string first_dataset(store::Catalog& catalog) {
    for (const auto& entry : catalog.list())
        if (entry.problem.empty()) return entry.name;
    throw limits::NotFound(
        "the server has no dataset; start the server with a dataset, or import a dataset into its folder");
}

} // namespace

protocol::SessionOpenResult session_open(CallContext& context, const protocol::SessionOpenParams& params) {
    const auto document = [&] {
        if (params.scene) return *params.scene;
        const std::string name = params.dataset ? *params.dataset : first_dataset(context.server.catalog());
        return geometry::default_scene(*context.dataset(name), name).document;
    };
    const sessions::UndoRedoSteps steps{params.undo.value_or(std::vector<nlohmann::json>()),
                                        params.redo.value_or(std::vector<nlohmann::json>())};
    const auto session = context.server.sessions().open(params.session.value_or(""), document, context.caller(), steps);
    if (context.streaming_connection()) session->subscribe(context.connection.id);
    return state_of(*session, session->status());
}

} // namespace server::methods
