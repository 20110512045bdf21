#include "methods/call_context.hpp"

namespace server::methods {

protocol::ViewCloseResult view_close(CallContext& context, const protocol::ViewCloseParams& params) {
    const auto view = context.view(params.view);
    context.server.sessions().close_view(view->id(), context.connection.id);
    return nullptr;
}

} // namespace server::methods
