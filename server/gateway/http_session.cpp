#include "gateway/http_session.hpp"

#include "gateway/deadline.hpp"
#include "gateway/http_request.hpp"
#include "gateway/remote_address.hpp"
#include "gateway/routes.hpp"
#include "gateway/rpc_call.hpp"
#include "gateway/websocket_session.hpp"
#include "limits/memory.hpp"
#include "logging/log.hpp"

#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <spdlog/spdlog.h>

namespace server::gateway {
namespace {

namespace http = beast::http;
using Parser = http::request_parser<http::string_body>;

constexpr std::size_t first_read_bytes = 4096;

constexpr std::string_view blank_line = "\r\n";
constexpr int blank_lines = 8; // most blank lines skipped before a request; RFC 9112, 2.2, requires at least one

class HttpSession {
public:
    HttpSession(ConnectionStart start, GatewayState& state, asio::thread_pool& workers)
        : start_(std::move(start)), state_(state), limits_(state.service.limits()),
          body_held_(state.service.memory(), limits::Held::requests), workers_(workers),
          stream_(std::move(start_.socket)), deadline_(stream_), guess_pause_(stream_.get_executor()) {
        address_ = without_mapping(start_.peer.address()).to_string();
        remote_ = address_ + ":" + std::to_string(start_.peer.port());
    }

    asio::awaitable<void> run() {
        *start_.on_drain = [this] {
            if (waiting_) stream_.cancel();
            guess_pause_.cancel();
        };
        *start_.on_cut = [this] { stream_.close(); };
        co_await look_up_user();
        while (co_await one_request()) {
        }
        *start_.on_drain = nullptr;
        *start_.on_cut = nullptr;
        co_await close();
    }

private:
    // Called before the first read, because a socket that the client has closed no longer has an owner.
    asio::awaitable<void> look_up_user() {
        if (!state_.access.own_user_enters || start_.ticket->is_refused()) co_return;
        error_code gone;
        const auto own = stream_.socket().local_endpoint(gone);
        if (gone) co_return;
        is_of_own_user_ = co_await state_.owners.is_own_user(start_.peer, own);
    }

    // Returns false if the connection must end.
    asio::awaitable<bool> one_request() {
        if (state_.draining && buffer_.size() == 0) co_return false;
        waiting_ = true;
        const bool begun = co_await request_begins();
        if (!begun) co_return false;
        Parser parser;
        parser.header_limit(static_cast<std::uint32_t>(limits_.header_bytes));
        parser.body_limit(limits_.message_bytes);
        error_code error;
        start_deadline(std::min(limits_.head_seconds, limits_.request_seconds));
        co_await http::async_read_header(stream_, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
        waiting_ = false;
        is_first_ = false;
        if (error || deadline_.passed()) {
            co_await answer_malformed(error);
            co_return false;
        }
        start_deadline(limits_.request_seconds);
        const bool goes_on = co_await answer(parser);
        start_.ticket->end_request();
        co_return goes_on;
    }

    void start_deadline(std::uint64_t seconds) {
        allowed_seconds_ = seconds;
        deadline_.start(std::chrono::seconds(seconds));
    }

    // Returns false if the peer has left or was idle too long. Blank lines do not extend the time limit.
    asio::awaitable<bool> request_begins() {
        error_code error;
        start_deadline(is_first_ ? std::min(limits_.head_seconds, limits_.keep_alive_seconds)
                                 : limits_.keep_alive_seconds);
        for (int skipped = 0; skipped < blank_lines && !error; skipped += skip_blank_line()) {
            if (buffer_.size() > 0 && !begins_with_blank_line()) co_return true; // has bytes of a request
            if (buffer_.size() >= blank_line.size()) continue;
            const std::size_t bytes = co_await stream_.async_read_some(
                buffer_.prepare(first_read_bytes), asio::redirect_error(asio::use_awaitable, error));
            buffer_.commit(bytes);
        }
        co_return !error;
    }

    // Returns whether the buffer begins with CR LF. Also true for an empty buffer and for a lone CR.
    bool begins_with_blank_line() const {
        const auto data = buffer_.data();
        const std::string_view text(static_cast<const char*>(data.data()), data.size());
        return blank_line.starts_with(text.substr(0, blank_line.size()));
    }
    int skip_blank_line() {
        if (buffer_.size() < blank_line.size() || !begins_with_blank_line()) return 0;
        buffer_.consume(blank_line.size());
        return 1;
    }

    // If a trusted proxy has forwarded the client's address, sets the address of `request`, and returns its
    // counting_key(). Else returns an empty text.
    std::string client_of(Request& request) const {
        const auto client = start_.is_of_trusted_proxy ? last_forwarded_for(request.forwarded_for) : std::nullopt;
        if (!client) return {};
        request.address = client->to_string();
        request.remote = request.address;
        return counting_key(*client);
    }

    Request request_of(const HttpRequest& message) const {
        Request request = plain_request(message);
        request.remote = remote_;
        request.id = logging::next_request_id();
        request.address = address_;
        request.is_of_own_user = is_of_own_user_;
        if (!start_.is_of_trusted_proxy) request.user = is_of_own_user_ && !request.is_proxied ? state_.own_user : "";
        return request;
    }

    // Checks the head of a request. The second result is true if the connection must end after the answer.
    std::pair<Resolved, bool> look_at(const HttpRequest& message, Request& request) {
        const std::string client = client_of(request);
        if (start_.ticket->is_refused()) return {refused(too_many_connections()), true};
        if (auto problem = refused_head(message)) return {refused(std::move(*problem)), true};
        Resolved resolved = resolve(state_, request);
        if (!start_.ticket->begin_request(is_let_in(resolved.claim), client))
            return {refused(too_many_of_address()), true};
        return {std::move(resolved), false};
    }

    asio::awaitable<bool> answer(Parser& parser) {
        Request request = request_of(parser.get());
        auto [resolved, is_last] = look_at(parser.get(), request);
        if (resolved.route != nullptr && resolved.route->kind == Route::Kind::websocket &&
            beast::websocket::is_upgrade(parser.get())) {
            if (auto problem = state_.draining ? stopping() : refused_handshake(parser.get()))
                resolved = refused(std::move(*problem));
            else {
                HttpRequest message = parser.release();
                Client client{0, request.remote, request.user, request.id, resolved.claim == Claim::token};
                co_await upgrade(std::move(message), std::move(client));
                co_return false;
            }
        }
        if (!resolved.refusal) {
            error_code error;
            body_held_.note(longest_body(parser));
            co_await read_body(parser, error);
            if (error || deadline_.passed()) {
                co_await answer_malformed(error);
                co_return false;
            }
            request.body = std::move(parser.get().body());
        }
        deadline_.stop();
        if (resolved.refusal && resolved.refusal->status == 401 && resolved.claim == Claim::wrong_token)
            co_await slow_down(request, resolved);
        else if (resolved.refusal)
            tell_refusal(request, *resolved.refusal);
        const bool unread = !parser.is_done();
        Response response = co_await response_to(request, resolved);
        body_held_.note(0);
        const bool keep_alive = parser.get().keep_alive() && !unread && !state_.draining && !is_last;
        const bool written =
            co_await write(std::move(response), request.method == "HEAD", parser.get().version(), keep_alive);
        if (written && (unread || is_last)) co_await linger();
        co_return written&& keep_alive;
    }

    void tell_refusal(const Request& request, const Response& refusal) {
        const std::string status = std::to_string(refusal.status);
        if (refusal.status < 400 || refusal.status == 404) return;
        if (!state_.log_limiter.allows(status + " " + logged_address(request.address))) return;
        logging::log_event(logging::LogLevel::warning, "a request was refused",
                           {{"status", status},
                            {"reason", refusal.body.substr(0, refusal.body.find('\n'))},
                            {"remote", request.address},
                            {"user", request.user},
                            {"request", request.id},
                            {"ms", request.milliseconds()},
                            {"note", "further refusals for this address are not logged for a minute"}});
    }

    // Delays the answer to a wrong token, so that guessing is slow. If too many answers wait, answers 429 at once.
    asio::awaitable<void> slow_down(const Request& request, Resolved& resolved) {
        if (state_.log_limiter.allows("token " + logged_address(request.address)))
            logging::log_event(logging::LogLevel::warning, "a wrong token was refused",
                               {{"remote", request.address},
                                {"user", request.user},
                                {"request", request.id},
                                {"ms", request.milliseconds()},
                                {"note", "further refusals for this address are not logged for a minute"}});
        if (state_.guesses_waiting.fetch_add(1) < limits_.wrong_tokens_waiting) {
            guess_pause_.expires_after(std::chrono::seconds(limits_.wrong_token_seconds));
            error_code ignored;
            co_await guess_pause_.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
        } else {
            resolved.refusal = sentence(429, "The server has too many requests with wrong tokens; try again later.");
            resolved.refusal->headers.emplace_back("Retry-After", std::to_string(limits_.wrong_token_seconds));
        }
        --state_.guesses_waiting;
    }

    static Resolved refused(Response response) { return {std::move(response), nullptr, {}, Claim::none}; }

    static std::optional<Response> stopping() {
        return sentence(503, "The server is about to stop; try again after its restart.");
    }

    static Response too_many_of_address() {
        Response response = sentence(429, "Your address has reached the limit on connections of one address; close a "
                                          "connection, or try again later.");
        response.headers.emplace_back("Retry-After", "1");
        return response;
    }

    static Response too_many_connections() {
        Response response = sentence(503, "The server has reached its limit on connections; try again later.");
        response.headers.emplace_back("Retry-After", "1");
        return response;
    }

    std::optional<Response> too_slow() const {
        return sentence(408, "The request did not arrive completely within " + std::to_string(allowed_seconds_) +
                                 " s; send it again.");
    }

    asio::awaitable<void> upgrade(HttpRequest message, Client client) {
        *start_.on_drain = nullptr;
        *start_.on_cut = nullptr; // a WebSocket is never closed to make room
        deadline_.stop();
        co_await websocket_session(std::move(stream_), std::move(message), std::move(client), start_.on_drain, state_,
                                   workers_);
    }

    [[nodiscard]] std::uint64_t longest_body(const Parser& parser) const {
        return parser.chunked() ? limits_.message_bytes
                                : std::min(parser.content_length().value_or(0), limits_.message_bytes);
    }

    asio::awaitable<void> read_body(Parser& parser, error_code& error) {
        if (beast::iequals(parser.get()[http::field::expect], "100-continue")) {
            const std::string go_on = "HTTP/1.1 100 Continue\r\n\r\n";
            co_await asio::async_write(stream_, asio::buffer(go_on), asio::redirect_error(asio::use_awaitable, error));
            if (error) co_return;
        }
        co_await http::async_read(stream_, buffer_, parser, asio::redirect_error(asio::use_awaitable, error));
    }

    asio::awaitable<Response> response_to(Request& request, const Resolved& resolved) {
        Response response;
        const auto kind = resolved.route == nullptr ? Route::Kind::quick : resolved.route->kind;
        if (kind == Route::Kind::rpc)
            response = co_await rpc_call(stream_, request, resolved.claim == Claim::token, state_, workers_);
        else if (kind == Route::Kind::quick || kind == Route::Kind::websocket)
            response = respond(state_, request, resolved);
        else
            co_await on_worker(state_.probe_thread, [&] {
                response = respond(state_, request, resolved);
                return std::string();
            });
        spdlog::debug("{} {} {} {}", request.remote, request.method, resolved.target.path, response.status);
        co_return response;
    }

    asio::awaitable<void> answer_malformed(const error_code& error) {
        auto refusal = deadline_.passed() ? too_slow() : refused_bytes(error);
        deadline_.stop();
        if (!refusal) co_return;
        const Resolved resolved = refused(std::move(*refusal));
        Request unknown;
        unknown.id = logging::next_request_id();
        unknown.address = address_;
        tell_refusal(unknown, *resolved.refusal);
        Response response = respond(state_, unknown, resolved);
        const bool written = co_await write(std::move(response), false, 11, false);
        if (written) co_await linger();
    }

    asio::awaitable<bool> write(Response response, bool head, unsigned version, bool keep_alive) {
        ++state_.counters.responses[std::min(response.status / 100, 5U)];
        http::response<http::string_body> message{static_cast<http::status>(response.status), version};
        message.set(http::field::date, http_date(std::time(nullptr)));
        for (const auto& [name, value] : response.headers) message.insert(name, value);
        message.keep_alive(keep_alive);
        limits::Memory::Charge held(state_.service.memory(), limits::Held::unsent);
        held.note(response.body.size());
        message.body() = std::move(response.body);
        if (response.status != 204 && response.status != 304) {
            message.set(http::field::content_type, response.content_type);
            message.prepare_payload();
        }
        http::response_serializer<http::string_body> serializer{message};
        serializer.split(head);
        error_code error;
        while (!error && !(head ? serializer.is_header_done() : serializer.is_done())) {
            // The time limit holds for this single write. A client that keeps accepting bytes can take longer in total.
            stream_.expires_after(std::chrono::seconds(limits_.request_seconds));
            co_await http::async_write_some(stream_, serializer, asio::redirect_error(asio::use_awaitable, error));
        }
        stream_.expires_never(); // deadline_ limits reads
        co_return !error;
    }

    // Reads until the peer closes: closing while the peer still sends would reset the connection and lose the answer.
    asio::awaitable<void> linger() {
        error_code error;
        stream_.socket().shutdown(asio::ip::tcp::socket::shutdown_send, error);
        stream_.expires_after(std::chrono::seconds(limits_.linger_seconds));
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
    GatewayState& state_;
    const limits::Limits& limits_;
    limits::Memory::Charge body_held_; // counts the body of the request in progress
    asio::thread_pool& workers_;
    beast::tcp_stream stream_;
    Deadline deadline_; // limits the reads from stream_
    asio::steady_timer guess_pause_;
    beast::flat_buffer buffer_;
    std::string remote_, address_; // address of the peer, with and without the port
    std::uint64_t allowed_seconds_ = 0;
    bool is_of_own_user_ = false, is_first_ = true;
    bool waiting_ = false; // waits for a request, or for the rest of its header
};

} // namespace

asio::awaitable<void> http_session(ConnectionStart start, GatewayState& state, asio::thread_pool& workers) {
    HttpSession session(std::move(start), state, workers);
    co_await session.run();
}

} // namespace server::gateway
