#include "methods/call_context.hpp"

namespace server::methods {

protocol::ViewAckResult view_ack(CallContext& context, const protocol::ViewAckParams& params) {
    const auto view = context.view(params.view);
    if (params.frame >= 1 && params.frame <= UINT32_MAX) view->acknowledge(static_cast<std::uint32_t>(params.frame));
    return nullptr;
}

} // namespace server::methods
