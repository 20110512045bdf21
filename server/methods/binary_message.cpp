#include "methods/binary_message.hpp"

#include "engine/metrics.hpp"
#include "engine/uploads.hpp"
#include "logging/log.hpp"
#include "methods/call_context.hpp"
#include "methods/error_answer.hpp"
#include "sessions/notify.hpp"

#include <chrono>

namespace server::methods {
namespace {

struct Failure {
    std::string reason, request;
};

using Clock = std::chrono::steady_clock;

// Counts and logs the current exception. Call it inside a catch block.
Failure note_failure(engine::Server& server, const sessions::Connection& connection, Clock::time_point begun) {
    const nlohmann::json error = error_of_current_exception();
    const int code = error["code"].get<int>();
    Failure failure{error["data"]["reason"], logging::next_request_id()};
    const std::chrono::duration<double, std::milli> taken = Clock::now() - begun;
    server.counters().count_error(code);
    logging::log_event(logging::LogLevel::info, "call failed",
                       {{"method", "append.piece"},
                        {"code", code},
                        {"reason", failure.reason},
                        {"request", failure.request},
                        {"ms", taken.count()},
                        {"user", connection.user},
                        {"remote", connection.remote}});
    return failure;
}

void add(engine::Server& server, const sessions::Connection& connection, const wire::UploadPiece& piece,
         Clock::time_point begun) {
    try {
        (void)server.uploads().add(piece);
    } catch (...) {
        const auto [reason, request] = note_failure(server, connection, begun);
        connection.send_text(
            sessions::notification_text(protocol::AppendRefused{engine::to_text(piece.upload), reason, request}));
    }
}

} // namespace

std::optional<std::string> receive_binary(engine::Server& server, const sessions::Connection& connection,
                                          std::span<const std::uint8_t> message) {
    const auto begun = Clock::now();
    try {
        check_may_append(server, connection);
        const wire::UploadPiece piece = wire::read_upload_piece(message);
        server.counters().count_request("append.piece");
        add(server, connection, piece, begun);
        return {};
    } catch (const limits::NotAllowed&) {
        (void)note_failure(server, connection, begun);
        return "binary messages carry the pieces of append.piece, which need `ciel serve --allow-append` and the "
               "server's token; send other calls as text";
    } catch (...) {
        return note_failure(server, connection, begun).reason;
    }
}

} // namespace server::methods
