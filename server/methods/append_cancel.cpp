#include "engine/uploads.hpp"
#include "methods/context.hpp"

namespace ciel::methods {

protocol::AppendCancelResult append_cancel(Context& context, const protocol::AppendCancelParams& params) {
    context.check_may_append();
    context.server.uploads().cancel(engine::upload_id(params.upload));
    return nullptr;
}

} // namespace ciel::methods
