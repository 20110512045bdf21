#include "methods/binary_message.hpp"

#include "methods/context.hpp"
#include "methods/error_answer.hpp"
#include "session/metrics.hpp"
#include "session/notify.hpp"
#include "session/uploads.hpp"

namespace ciel::methods {
namespace {

void add(session::Server& server, const session::Connection& connection, const wire::UploadPiece& piece) {
    try {
        (void)server.uploads().add(piece);
    } catch (...) {
        const nlohmann::json error = error_of_current_exception();
        server.counters().count_error(error["code"].get<int>());
        connection.send_text(session::notification_text(
            protocol::AppendRefused{session::to_text(piece.upload), error["data"]["reason"]}));
    }
}

} // namespace

std::optional<std::string> receive_binary(session::Server& server, const session::Connection& connection,
                                          std::span<const std::uint8_t> message) {
    try {
        check_may_append(server, connection);
        const wire::UploadPiece piece = wire::read_upload_piece(message);
        server.counters().count_request("append.piece");
        add(server, connection, piece);
        return {};
    } catch (const session::NotAllowed&) {
        return "send JSON-RPC as text";
    } catch (const std::exception& error) {
        return error.what();
    }
}

} // namespace ciel::methods
