#include "methods/context.hpp"
#include "session/default_scene.hpp"

namespace ciel::methods {

protocol::DatasetOpenResult dataset_open(Context& context, const protocol::DatasetOpenParams& params) {
    const auto session = context.session(params.session);
    const auto loaded = context.dataset(params.dataset);
    const auto scene = session::default_scene(*loaded, params.dataset).document;
    return state_of(*session, session->replace(scene, context.connection.id));
}

} // namespace ciel::methods
