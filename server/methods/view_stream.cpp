#include "methods/context.hpp"

namespace ciel::methods {

protocol::ViewStreamResult view_stream(Context& context, const protocol::ViewStreamParams& params) {
    context.view(params.view)
        ->set_stream(params.stream == "geometry" ? session::Stream::geometry : session::Stream::image);
    return nullptr;
}

} // namespace ciel::methods
