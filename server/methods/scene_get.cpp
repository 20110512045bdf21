#include "methods/call_context.hpp"

namespace server::methods {

protocol::SceneGetResult scene_get(CallContext& context, const protocol::SceneGetParams& params) {
    const auto session = context.session(params.session);
    return state_of(*session, session->status());
}

} // namespace server::methods
