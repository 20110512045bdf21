#include "methods/call_context.hpp"

namespace server::methods {

protocol::DatasetListResult dataset_list(CallContext& context, const protocol::DatasetListParams&) {
    protocol::DatasetListResult list;
    for (const auto& entry : context.server.catalog().list()) list.push_back({entry.name, entry.problem});
    return list;
}

} // namespace server::methods
