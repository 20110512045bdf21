#include "methods/context.hpp"

namespace ciel::methods {

protocol::SessionCloseResult session_close(Context& context, const protocol::SessionCloseParams& params) {
    context.server.sessions().close(params.session, context.caller());
    return nullptr;
}

} // namespace ciel::methods
