#include "methods/call_context.hpp"

namespace ciel::methods {

protocol::SceneGetResult scene_get(CallContext& context, const protocol::SceneGetParams& params) {
    const auto session = context.session(params.session);
    return state_of(*session, session->status());
}

} // namespace ciel::methods
