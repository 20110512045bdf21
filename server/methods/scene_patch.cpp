#include "methods/context.hpp"

namespace ciel::methods {

protocol::ScenePatchResult scene_patch(Context& context, const protocol::ScenePatchParams& params) {
    const auto status =
        context.session(params.session)->patch(params.patch, params.gesture.value_or(""), context.connection.id);
    return {static_cast<std::int64_t>(status.version->revision), status.can_undo, status.can_redo};
}

} // namespace ciel::methods
