#include "gateway/http_session.hpp"

#include "gateway/deadline.hpp"
#include "gateway/routes.hpp"
#include "gateway/rpc_call.hpp"
#include "gateway/websocket_session.hpp"

#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <spdlog/spdlog.h>

namespace ciel::gateway {
namespace {

namespace http = beast::http;
using Parser = http::request_parser<http::string_body>;

constexpr std::size_t first_read_bytes = 4096;
constexpr std::chrono::seconds linger_time{2};

std::string text_of(boost::string_view view) { return {view.data(), view.size()}; }

Request plain(HttpRequest& message, const std::string& remote) {
    Request request;
    request.method = text_of(message.method_string());
    request.target = text_of(message.target());
    request.host = text_of(message[http::field::host]);
    request.origin = text_of(message[http::field::origin]);
    request.authorization = text_of(message[http::field::authorization]);
    request.cookie = text_of(message[http::field::cookie]);
    request.content_type = text_of(message[http::field::content_type]);
    request.if_none_match = text_of(message[http::field::if_none_match]);
    request.forwarded_proto = text_of(message["X-Forwarded-Proto"]);
    request.remote = remote;
    return request;
}

// The answer to what is not HTTP as we read it; nothing when the peer has gone.
std::optional<Response> malformed(const error_code& error) {
    if (error == http::error::header_limit)
        return sentence(431, "The request's header is larger than this server takes; server.info names the limit.");
    if (error == http::error::body_limit)
        return sentence(413, "The request is larger than this server takes; server.info names the limit.");
    if (error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
    if (error.category() == http::make_error_code(http::error::bad_method).category())
        return sentence(400, "This is not an HTTP/1.1 request: " + error.message() + ".");
    return std::nullopt;
}

class HttpSession {
public:
    HttpSession(ConnectionStart start, Context& context, asio::thread_pool& workers)
        : start_(std::move(start)), context_(context), workers_(workers), stream_(std::move(start_.socket)),
          deadline_(stream_) {
        error_code ignored;
        const auto peer = stream_.socket().remote_endpoint(ignored);
        if (!ignored) remote_ = peer.address().to_string() + ":" + std::to_string(peer.port());
    }

    asio::awaitable<void> run() {
        *start_.on_drain = [this] {
            if (waiting_) stream_.cancel();
        };
        while (co_await one_request()) {
        }
        *start_.on_drain = nullptr;
        co_await close();
    }

private:
    // False when the connection ends with it.
    asio::awaitable<bool> one_request() {
        waiting_ = true;
        const bool begun = co_await request_begins();
        if (!begun) co_return false;
        const auto& limits = context_.server.limits();
        Parser parser;
        parser.header_limit(static_cast<std::uint32_t>(limits.header_bytes));
        parser.body_limit(limits.message_bytes);
        error_code error;
        deadline_.start(std::chrono::seconds(limits.request_seconds)); // for the whole request
        co_await http::async_read_header(stream_, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
        waiting_ = false;
        if (error || deadline_.passed()) {
            co_await answer_malformed(error);
            co_return false;
        }
        const bool goes_on = co_await answer(parser);
        co_return goes_on;
    }

    // False when the peer has gone, or for too long says nothing: that is no fault and gets no answer.
    asio::awaitable<bool> request_begins() {
        if (buffer_.size() > 0) co_return true; // pipelined
        deadline_.start(std::chrono::seconds(context_.server.limits().keep_alive_seconds));
        error_code error;
        const std::size_t bytes = co_await stream_.async_read_some(buffer_.prepare(first_read_bytes),
                                                                   asio::redirect_error(asio::use_awaitable, error));
        buffer_.commit(bytes);
        co_return !error;
    }

    asio::awaitable<bool> answer(Parser& parser) {
        Request request = plain(parser.get(), remote_);
        Resolved resolved = resolve(context_, request);
        if (parser.get().count(http::field::host) != 1 && parser.get().version() >= 11)
            resolved = {sentence(400, "HTTP/1.1 needs exactly one Host header."), nullptr, {}, false};
        if (start_.over_limit) resolved = {too_many_connections(), nullptr, {}, false};
        if (resolved.route != nullptr && resolved.route->kind == Route::Kind::websocket &&
            beast::websocket::is_upgrade(parser.get())) {
            if (auto problem = refused_upgrade(parser.get()))
                resolved = {std::move(problem), nullptr, {}, false};
            else {
                HttpRequest message = parser.release();
                co_await upgrade(std::move(message), resolved.has_token);
                co_return false;
            }
        }
        if (!resolved.refusal) {
            error_code error;
            co_await read_body(parser, error);
            if (error || deadline_.passed()) {
                co_await answer_malformed(error);
                co_return false;
            }
            request.body = std::move(parser.get().body());
        }
        deadline_.stop();
        const bool unread = !parser.is_done();
        Response response = co_await response_to(request, resolved);
        const bool keep_alive = parser.get().keep_alive() && !unread && !context_.draining && !start_.over_limit;
        const bool written =
            co_await write(std::move(response), request.method == "HEAD", parser.get().version(), keep_alive);
        if (written && unread) co_await linger();
        co_return written&& keep_alive;
    }

    static Response too_many_connections() {
        Response response = sentence(503, "The server has as many connections as it takes; try again later.");
        response.headers.emplace_back("Retry-After", "1");
        return response;
    }

    std::optional<Response> too_slow() const {
        return sentence(408, "The request did not arrive whole within " +
                                 std::to_string(context_.server.limits().request_seconds) + " s.");
    }

    std::optional<Response> refused_upgrade(const HttpRequest& message) const {
        if (!offers_subprotocol(text_of(message[http::field::sec_websocket_protocol])))
            return sentence(400, "This WebSocket needs the subprotocol ciel.v1 (Sec-WebSocket-Protocol).");
        if (context_.draining) return sentence(503, "The server is about to stop.");
        return std::nullopt;
    }

    asio::awaitable<void> upgrade(HttpRequest message, bool has_token) {
        *start_.on_drain = nullptr;
        deadline_.stop();
        const WebSocketPeer peer{remote_, has_token};
        co_await websocket_session(std::move(stream_), std::move(message), peer, start_.on_drain, context_, workers_);
    }

    asio::awaitable<void> read_body(Parser& parser, error_code& error) {
        if (beast::iequals(parser.get()[http::field::expect], "100-continue")) {
            const std::string go_on = "HTTP/1.1 100 Continue\r\n\r\n";
            co_await asio::async_write(stream_, asio::buffer(go_on), asio::redirect_error(asio::use_awaitable, error));
            if (error) co_return;
        }
        co_await http::async_read(stream_, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
    }

    asio::awaitable<Response> response_to(const Request& request, const Resolved& resolved) {
        Response response;
        const auto kind = resolved.route == nullptr ? Route::Kind::quick : resolved.route->kind;
        if (kind == Route::Kind::rpc)
            response = co_await rpc_call(stream_, request, resolved.has_token, context_, workers_);
        else if (kind != Route::Kind::on_worker)
            response = respond(context_, request, resolved);
        else
            co_await on_worker(workers_, [&] {
                response = respond(context_, request, resolved);
                return std::string();
            });
        spdlog::debug("{} {} {} {}", remote_, request.method, resolved.target.path, response.status);
        co_return response;
    }

    asio::awaitable<void> answer_malformed(const error_code& error) {
        auto refusal = deadline_.passed() ? too_slow() : malformed(error);
        deadline_.stop();
        if (!refusal) co_return;
        const Resolved resolved{std::move(refusal), nullptr, {}, false};
        const Request unknown;
        Response response = respond(context_, unknown, resolved);
        const bool written = co_await write(std::move(response), false, 11, false);
        if (written) co_await linger();
    }

    asio::awaitable<bool> write(Response response, bool head, unsigned version, bool keep_alive) {
        ++context_.counters.responses[std::min(response.status / 100, 5U)];
        http::response<http::string_body> message{static_cast<http::status>(response.status), version};
        for (const auto& [name, value] : response.headers) message.insert(name, value);
        message.keep_alive(keep_alive);
        message.body() = std::move(response.body);
        if (response.status != 204 && response.status != 304) {
            message.set(http::field::content_type, response.content_type);
            message.prepare_payload();
        }
        http::response_serializer<http::string_body> serializer{message};
        serializer.split(head);
        error_code error;
        while (!error && !(head ? serializer.is_header_done() : serializer.is_done())) {
            stream_.expires_after(std::chrono::seconds(context_.server.limits().request_seconds)); // to take some of it
            co_await http::async_write_some(stream_, serializer, asio::redirect_error(asio::use_awaitable, error));
        }
        stream_.expires_never(); // what is read next has a deadline of its own
        co_return !error;
    }

    // A peer that still sends would lose the answer to a reset if the socket closed at once.
    asio::awaitable<void> linger() {
        error_code error;
        stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
        stream_.expires_after(linger_time);
        std::array<char, 16384> sink;
        while (!error)
            co_await stream_.async_read_some(asio::buffer(sink), asio::redirect_error(asio::use_awaitable, error));
    }

    asio::awaitable<void> close() {
        error_code ignored;
        if (stream_.socket().is_open()) stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, ignored);
        stream_.close();
        co_return;
    }

    ConnectionStart start_;
    Context& context_;
    asio::thread_pool& workers_;
    beast::tcp_stream stream_;
    Deadline deadline_; // of what is read
    beast::flat_buffer buffer_;
    std::string remote_;
    bool waiting_ = false; // for a request, or for the rest of its header
};

} // namespace

asio::awaitable<void> http_session(ConnectionStart start, Context& context, asio::thread_pool& workers) {
    HttpSession session(std::move(start), context, workers);
    co_await session.run();
}

} // namespace ciel::gateway
