#include "methods/call_context.hpp"

namespace server::methods {

protocol::ViewStreamResult view_stream(CallContext& context, const protocol::ViewStreamParams& params) {
    std::optional<wire::MovingCodec> moving;
    if (params.moving) moving = *params.moving == "jpeg" ? wire::MovingCodec::jpeg : wire::MovingCodec::png;
    context.view(params.view)
        ->set_stream(params.stream == "geometry" ? engine::Stream::geometry : engine::Stream::image, moving);
    return nullptr;
}

} // namespace server::methods
