#include "engine/uploads.hpp"
#include "methods/call_context.hpp"

namespace server::methods {
namespace {

protocol::ExpectedArray expected(const store::PlannedArray& array) {
    const bool on_points = array.info.association == store::Association::point;
    return {array.info.name, on_points ? "point" : "cell", array.info.components,
            static_cast<std::int64_t>(array.tuples), static_cast<std::int64_t>(engine::upload_bytes(array))};
}

} // namespace

protocol::AppendBeginResult append_begin(CallContext& context, const protocol::AppendBeginParams& params) {
    context.check_may_append();
    std::vector<store::WantedArray> wanted;
    for (const auto& array : params.arrays) wanted.push_back({array.name, array.components, array.type == "float64"});
    const auto begun =
        context.server.uploads().begin(params.dataset, context.dataset(params.dataset), params.time, std::move(wanted));
    const limits::Limits& limits = context.server.limits();
    protocol::Upload upload{engine::to_text(begun.id), static_cast<std::int64_t>(limits.upload_piece_bytes),
                            static_cast<std::int64_t>(limits.upload_idle_seconds)};
    for (const auto& array : begun.plan.arrays) {
        upload.arrays.push_back(expected(array));
        if (array.made) upload.made.push_back(array.made->name);
    }
    upload.added = begun.plan.added;
    upload.lacking = begun.plan.lacking;
    upload.rounded = begun.plan.rounded;
    return upload;
}

} // namespace server::methods
