#include "methods/binary_message.hpp"

#include "engine/metrics.hpp"
#include "engine/uploads.hpp"
#include "logging/log.hpp"
#include "methods/call_context.hpp"
#include "methods/error_answer.hpp"
#include "sessions/notify.hpp"

namespace server::methods {
namespace {

void add(engine::Server& server, const sessions::Connection& connection, const wire::UploadPiece& piece) {
    try {
        (void)server.uploads().add(piece);
    } catch (...) {
        const nlohmann::json error = error_of_current_exception();
        const int code = error["code"].get<int>();
        const std::string reason = error["data"]["reason"], request = logging::next_request_id();
        server.counters().count_error(code);
        logging::log_event(logging::LogLevel::info, "call failed",
                           {{"method", "append.piece"},
                            {"code", code},
                            {"reason", reason},
                            {"request", request},
                            {"user", connection.user},
                            {"remote", connection.remote}});
        connection.send_text(
            sessions::notification_text(protocol::AppendRefused{engine::to_text(piece.upload), reason, request}));
    }
}

} // namespace

std::optional<std::string> receive_binary(engine::Server& server, const sessions::Connection& connection,
                                          std::span<const std::uint8_t> message) {
    try {
        check_may_append(server, connection);
        const wire::UploadPiece piece = wire::read_upload_piece(message);
        server.counters().count_request("append.piece");
        add(server, connection, piece);
        return {};
    } catch (const limits::NotAllowed&) {
        return "binary messages carry the pieces of append.piece, which need `ciel serve --allow-append` and the "
               "server's token; send other calls as text";
    } catch (const std::exception& error) {
        return error.what();
    }
}

} // namespace server::methods
