#include "gateway/rpc_call.hpp"

#include "gateway/handlers.hpp"
#include "gateway/hang_up.hpp"

#include <boost/asio/post.hpp>
#include <optional>

namespace server::gateway {
namespace {

// Used on the stream's executor only.
struct Pending {
    explicit Pending(const beast::tcp_stream::executor_type& executor) : answered(executor) {
        answered.expires_at(std::chrono::steady_clock::time_point::max());
    }
    asio::steady_timer answered; // never expires; cancelled when the answer arrives
    std::optional<std::string> answer;
    std::stop_source hung_up;
};

// Calls Peer::closed and stops the call when the client closes its side.
void watch(beast::tcp_stream& stream, const std::shared_ptr<Pending>& pending, const std::shared_ptr<Peer>& peer,
           asio::thread_pool& workers) {
    stream.socket().async_wait(asio::ip::tcp::socket::wait_read,
                               [&stream, pending, peer, &workers](const error_code& error) {
                                   if (pending->answer) return; // the stream may no longer exist
                                   const PeerState state = error ? PeerState::hung_up : state_of_peer(stream.socket());
                                   if (state == PeerState::waits) return watch(stream, pending, peer, workers);
                                   if (state == PeerState::sends) return; // the bytes are a pipelined request
                                   pending->hung_up.request_stop();
                                   asio::post(workers, [peer] { peer->closed(); });
                               });
}

} // namespace

asio::awaitable<Response> rpc_call(beast::tcp_stream& stream, Request& request, bool has_token, GatewayState& state,
                                   asio::thread_pool& workers) {
    const auto pending = std::make_shared<Pending>(stream.get_executor());
    const auto peer = state.service.connect({state.next_connection_id++, request.remote, request.user, request.id,
                                             has_token, pending->hung_up.get_token()});
    const auto answer = [pending, executor = stream.get_executor()](std::string text) {
        asio::post(executor, [pending, text = std::move(text)]() mutable {
            pending->answer = std::move(text);
            pending->answered.cancel();
        });
    };
    co_await on_worker(workers, [&] {
        peer->text(request.body, answer);
        request.body = std::string(); // a queued call owns the parsed text and counts its memory
        return std::string();
    });
    if (!pending->answer) watch(stream, pending, peer, workers);
    error_code ignored;
    while (!pending->answer) co_await pending->answered.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    stream.socket().cancel(ignored); // ends watch()
    const unsigned status = pending->answer->empty() ? 204 : 200;
    Response response = json(status, std::move(*pending->answer));
    add_common_headers(state, request, response);
    co_return response;
}

} // namespace server::gateway
