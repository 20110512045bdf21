#include "engine/uploads.hpp"
#include "methods/progress.hpp"

namespace server::methods {

protocol::AppendCommitResult append_commit(CallContext& context, const protocol::AppendCommitParams& params) {
    context.check_may_append();
    Progress progress(context, params.progress, std::nullopt);
    progress.begin("waiting");
    const auto done =
        context.server.uploads().commit(engine::upload_id(params.upload), [&](std::size_t written, std::size_t of) {
            progress.count("writing", written, of);
        });
    context.server.look_for_steps(done.dataset, *done.loaded);
    return {static_cast<std::int64_t>(done.step), done.time};
}

} // namespace server::methods
