#include "frames/picture.hpp"
#include "methods/call_context.hpp"

namespace server::methods {

protocol::ViewOpenResult view_open(CallContext& context, const protocol::ViewOpenParams& params) {
    const auto session = context.session(params.session);
    frames::check_picture_size(context.server.limits(), params.width, params.height);
    const auto connection = context.streaming_connection();
    if (!connection)
        throw NeedsWebSocket("view.open needs a WebSocket, which carries the frames; over HTTP, use picture.render");
    const auto view = context.server.sessions().open_view(
        *session, connection,
        {static_cast<std::uint32_t>(params.width), static_cast<std::uint32_t>(params.height), params.pixel_ratio},
        params.stream == "geometry" ? engine::Stream::geometry : engine::Stream::image,
        params.moving == "jpeg" ? wire::MovingCodec::jpeg : wire::MovingCodec::png);
    return {view->id()};
}

} // namespace server::methods
