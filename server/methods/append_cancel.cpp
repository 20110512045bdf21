#include "methods/context.hpp"
#include "session/uploads.hpp"

namespace ciel::methods {

protocol::AppendCancelResult append_cancel(Context& context, const protocol::AppendCancelParams& params) {
    context.check_may_append();
    context.server.uploads().cancel(session::upload_id(params.upload));
    return nullptr;
}

} // namespace ciel::methods
