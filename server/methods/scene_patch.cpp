#include "methods/call_context.hpp"

namespace server::methods {

protocol::ScenePatchResult scene_patch(CallContext& context, const protocol::ScenePatchParams& params) {
    const std::string gesture = params.gesture.value_or("");
    if (gesture.size() > scene::most_name_bytes) // the contract limits characters, not bytes
        throw InvalidParams("/gesture",
                            "/gesture may have at most " + std::to_string(scene::most_name_bytes) + " bytes of UTF-8");
    const auto status = context.session(params.session)->patch(params.patch, gesture, context.author());
    return {static_cast<std::int64_t>(status.version->revision), status.can_undo, status.can_redo};
}

} // namespace server::methods
