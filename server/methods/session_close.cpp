#include "methods/call_context.hpp"

namespace server::methods {

protocol::SessionCloseResult session_close(CallContext& context, const protocol::SessionCloseParams& params) {
    context.server.sessions().close(params.session, context.caller());
    return nullptr;
}

} // namespace server::methods
