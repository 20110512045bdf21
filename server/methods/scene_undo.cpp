#include "methods/call_context.hpp"

namespace server::methods {

protocol::SceneUndoResult scene_undo(CallContext& context, const protocol::SceneUndoParams& params) {
    const auto session = context.session(params.session);
    return state_of(*session, session->undo(context.author()));
}

} // namespace server::methods
