#include "methods/call_context.hpp"

namespace server::methods {

protocol::SceneRedoResult scene_redo(CallContext& context, const protocol::SceneRedoParams& params) {
    const auto session = context.session(params.session);
    return state_of(*session, session->redo(context.author()));
}

} // namespace server::methods
