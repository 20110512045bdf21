#include "frames/picture.hpp"
#include "methods/call_context.hpp"

namespace server::methods {

protocol::ViewResizeResult view_resize(CallContext& context, const protocol::ViewResizeParams& params) {
    const auto view = context.view(params.view);
    frames::check_picture_size(context.server.limits(), params.width, params.height);
    view->resize(static_cast<std::uint32_t>(params.width), static_cast<std::uint32_t>(params.height),
                 params.pixel_ratio);
    return nullptr;
}

} // namespace server::methods
