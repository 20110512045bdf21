#include "engine/uploads.hpp"
#include "methods/base64.hpp"
#include "methods/call_context.hpp"

namespace server::methods {

protocol::AppendPieceResult append_piece(CallContext& context, const protocol::AppendPieceParams& params) {
    context.check_may_append();
    const auto bytes = from_base64(params.data);
    if (!bytes)
        throw InvalidParams(
            "/data", "/data is not base64; encode it as in RFC 4648, section 4, with padding and without blanks");
    const std::uint64_t received =
        context.server.uploads().add({engine::upload_id(params.upload), static_cast<std::uint32_t>(params.array),
                                      static_cast<std::uint64_t>(params.offset), *bytes});
    return {static_cast<std::int64_t>(received)};
}

} // namespace server::methods
