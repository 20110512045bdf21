#include "engine/uploads.hpp"
#include "methods/call_context.hpp"

namespace server::methods {

protocol::AppendCancelResult append_cancel(CallContext& context, const protocol::AppendCancelParams& params) {
    context.check_may_append();
    context.server.uploads().cancel(engine::upload_id(params.upload));
    return nullptr;
}

} // namespace server::methods
