#include "methods/context.hpp"

namespace ciel::methods {

protocol::ViewStreamResult view_stream(Context& context, const protocol::ViewStreamParams& params) {
    std::optional<session::MovingCodec> moving;
    if (params.moving) moving = *params.moving == "jpeg" ? session::MovingCodec::jpeg : session::MovingCodec::png;
    context.view(params.view)
        ->set_stream(params.stream == "geometry" ? session::Stream::geometry : session::Stream::image, moving);
    return nullptr;
}

} // namespace ciel::methods
