#include "geometry/default_scene.hpp"
#include "methods/call_context.hpp"

namespace server::methods {

protocol::DatasetOpenResult dataset_open(CallContext& context, const protocol::DatasetOpenParams& params) {
    const auto session = context.session(params.session);
    const auto loaded = context.dataset(params.dataset);
    const auto scene = geometry::default_scene(*loaded, params.dataset).document;
    return state_of(*session, session->replace(scene, context.author()));
}

} // namespace server::methods
