#include "engine/uploads.hpp"
#include "methods/context.hpp"

namespace ciel::methods {

protocol::AppendCommitResult append_commit(Context& context, const protocol::AppendCommitParams& params) {
    context.check_may_append();
    const auto done = context.server.uploads().commit(engine::upload_id(params.upload));
    context.server.look_for_steps(done.dataset, *done.loaded);
    return {static_cast<std::int64_t>(done.step), done.time};
}

} // namespace ciel::methods
