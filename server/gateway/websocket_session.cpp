#include "gateway/websocket_session.hpp"

#include "gateway/send_queue.hpp"
#include "logging/log.hpp"

#include <boost/asio/post.hpp>
#include <boost/beast/core/buffers_to_string.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket/stream.hpp>
#include <deque>
#include <netinet/tcp.h>
#include <optional>
#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <utility>

namespace server::gateway {
namespace {

namespace websocket = beast::websocket;
using websocket::close_code;

constexpr int unsent_bytes = 128 << 10; // in the socket buffer; small, because texts cannot overtake these bytes
constexpr std::size_t close_reason_bytes = 123; // RFC 6455, 5.5.1: 125 bytes of a control frame less 2 of the code
// Largest valid close code (RFC 6455, 7.4.2). Beast itself refuses smaller codes that are invalid.
constexpr unsigned last_close_code = 4999;

// All members are used on the socket's strand, except by work on `workers` and by the Client's callbacks.
class WebSocketSession : public std::enable_shared_from_this<WebSocketSession> {
public:
    WebSocketSession(beast::tcp_stream stream, GatewayState& state, asio::thread_pool& workers)
        : state_(state), workers_(workers), socket_(std::move(stream)),
          inbox_held_(state.service.memory(), limits::Held::requests), inbox_changed_(socket_.get_executor()),
          send_queue_changed_(socket_.get_executor()), coroutine_ended_(socket_.get_executor()) {
        for (auto* timer : {&inbox_changed_, &send_queue_changed_, &coroutine_ended_})
            timer->expires_at(std::chrono::steady_clock::time_point::max());
    }

    asio::awaitable<void> run(HttpRequest upgrade, Client client, OnDrain on_drain);

private:
    asio::awaitable<bool> accept(HttpRequest upgrade);
    void open(Client client);
    asio::awaitable<void> read();
    asio::awaitable<void> handle_in_order();
    asio::awaitable<void> write();
    template <typename Coroutine>
    void start(Coroutine coroutine);

    // The timer never expires. It serves as a condition variable: cancelling it wakes all waiters.
    static asio::awaitable<void> changed(asio::steady_timer& timer) {
        error_code ignored;
        co_await timer.async_wait(asio::redirect_error(asio::use_awaitable, ignored));
    }
    void request_close(close_code code, std::string_view reason) {
        std::size_t bytes = std::min(reason.size(), close_reason_bytes);
        while (bytes > 0 && bytes < reason.size() && (reason[bytes] & 0xC0) == 0x80) --bytes; // keeps characters whole
        if (!close_) close_ = websocket::close_reason(code, boost::string_view(reason.data(), bytes));
        send_queue_changed_.cancel();
    }
    void drain();
    Answer answer();
    std::string take_binary(std::string_view bytes, const Answer& reply);
    void send_queue_pushed();
    void end();
    void log_end(std::string_view reason) const;
    void cut() { beast::get_lowest_layer(socket_).close(); }

    GatewayState& state_;
    asio::thread_pool& workers_;
    websocket::stream<beast::tcp_stream> socket_;
    std::shared_ptr<SendQueue> send_queue_;
    std::shared_ptr<Peer> peer_;
    std::string remote_, user_, request_; // request_: id of the upgrade
    std::chrono::steady_clock::time_point opened_ = std::chrono::steady_clock::now();
    std::stop_source closed_;
    struct Inbound {
        std::string bytes;
        bool is_text;
    };
    std::deque<Inbound> inbox_;
    std::size_t inbox_bytes_ = 0;
    limits::Memory::Charge inbox_held_; // counts inbox_bytes_
    asio::steady_timer inbox_changed_, send_queue_changed_, coroutine_ended_;
    std::optional<websocket::close_reason> close_; // requested close; write() sends it after the waiting messages
    bool ended_ = false, closes_now_ = false, writing_ = false;
    int coroutines_ = 0, unanswered_ = 0; // running coroutines; messages taken from the inbox but not answered
};

asio::awaitable<bool> WebSocketSession::accept(HttpRequest upgrade) {
    const auto& limits = state_.service.limits();
    beast::get_lowest_layer(socket_).expires_never(); // the WebSocket has its own time-outs
    ::setsockopt(beast::get_lowest_layer(socket_).socket().native_handle(), IPPROTO_TCP, TCP_NOTSENT_LOWAT,
                 &unsent_bytes, sizeof unsent_bytes); // if this fails, texts wait longer
    websocket::stream_base::timeout timeouts{};
    timeouts.handshake_timeout = std::chrono::milliseconds(500) * limits.drain_seconds;
    timeouts.idle_timeout = std::chrono::seconds(limits.websocket_idle_seconds);
    timeouts.keep_alive_pings = true;
    socket_.set_option(timeouts);
    socket_.set_option(websocket::stream_base::decorator([this](websocket::response_type& response) {
        response.set(beast::http::field::sec_websocket_protocol, std::string(subprotocol));
        response.set(beast::http::field::server, "CIEL/" + state_.version);
        response.set("X-Request-Id", request_);
    }));
    socket_.control_callback([this](websocket::frame_type kind, boost::beast::string_view) {
        // Disconnects on an invalid close code, because Beast would send the code back.
        if (kind == websocket::frame_type::close && socket_.reason().code > last_close_code) cut();
    });
    socket_.read_message_max(limits.message_bytes);
    socket_.auto_fragment(false); // writes each message as one WebSocket frame, without a copy
    error_code error;
    co_await socket_.async_accept(upgrade, asio::redirect_error(asio::use_awaitable, error));
    if (!error) ++state_.counters.responses[1]; // the 101
    co_return !error;
}

void WebSocketSession::open(Client client) {
    const std::weak_ptr<WebSocketSession> weak = weak_from_this();
    send_queue_ =
        std::make_shared<SendQueue>(state_.service.limits().unsent_bytes, state_.service.memory(), [this, weak] {
            asio::post(socket_.get_executor(), [weak] {
                if (const auto self = weak.lock()) self->send_queue_pushed();
            });
        });
    remote_ = client.remote;
    user_ = client.user;
    client.id = state_.next_connection_id++;
    client.stop = closed_.get_token();
    client.send_text = [send_queue = send_queue_](std::string text) { send_queue->push_text(std::move(text)); };
    client.send_binary = [send_queue = send_queue_](FrameBytes bytes) { send_queue->push_frame(std::move(bytes)); };
    client.has_room = [send_queue = send_queue_](std::size_t bytes) { return send_queue->has_room(bytes); };
    peer_ = state_.service.connect(std::move(client));
}

asio::awaitable<void> WebSocketSession::run(HttpRequest upgrade, Client client, OnDrain on_drain) {
    request_ = std::exchange(client.request, {});
    const bool accepted = co_await accept(std::move(upgrade));
    if (!accepted) co_return;
    spdlog::debug("{}: WebSocket opened", client.remote);
    ++state_.counters.websockets_open;
    open(std::move(client));
    *on_drain = [this] { drain(); };
    start([this] { return handle_in_order(); });
    start([this] { return write(); });
    co_await read();
    end();
    while (coroutines_ > 0) co_await changed(coroutine_ended_);
    *on_drain = nullptr;
    send_queue_->close();
    state_.counters.frames_dropped += send_queue_->dropped_frames();
    co_await on_worker(workers_, [this] {
        peer_->closed();
        return std::string();
    });
    --state_.counters.websockets_open;
    spdlog::debug("{}: WebSocket closed", remote_);
}

template <typename Coroutine>
void WebSocketSession::start(Coroutine coroutine) {
    ++coroutines_;
    asio::co_spawn(socket_.get_executor(), std::move(coroutine), [this](const std::exception_ptr& failure) {
        if (failure) cut();
        --coroutines_;
        coroutine_ended_.cancel();
    });
}

asio::awaitable<void> WebSocketSession::read() {
    while (!ended_) {
        beast::flat_buffer buffer;
        error_code error;
        co_await socket_.async_read(buffer, asio::redirect_error(asio::use_awaitable, error));
        const bool is_bad_message = error == websocket::condition::protocol_violation ||
                                    error == websocket::error::message_too_big ||
                                    error == websocket::error::buffer_overflow;
        if (is_bad_message) log_end(error.message()); // Beast has sent 1002, 1007 or 1009
        if (error) co_return;                         // bad message, closed, lost or idle too long
        if (close_) continue;
        if (socket_.got_text()) ++state_.counters.texts_received;
        inbox_bytes_ += buffer.size();
        inbox_held_.note(inbox_bytes_);
        inbox_.push_back({beast::buffers_to_string(buffer.data()), socket_.got_text()});
        inbox_changed_.cancel();
        while (inbox_bytes_ > state_.service.limits().waiting_call_bytes && !ended_) co_await changed(inbox_changed_);
    }
}

asio::awaitable<void> WebSocketSession::handle_in_order() {
    while (!ended_) {
        if (inbox_.empty()) {
            co_await changed(inbox_changed_);
            continue;
        }
        const Inbound message = std::move(inbox_.front());
        inbox_.pop_front();
        ++unanswered_;
        const Answer reply = answer();
        const std::string problem = co_await on_worker(workers_, [&] {
            if (message.is_text)
                peer_->text(message.bytes, reply);
            else
                return take_binary(message.bytes, reply);
            return std::string();
        });
        if (!problem.empty()) {
            log_end(problem);
            request_close(close_code::unknown_data, problem);
        }
        inbox_bytes_ -= message.bytes.size();
        inbox_held_.note(inbox_bytes_);
        inbox_changed_.cancel();
    }
}

// Handles an upload piece. Returns the reason to close the connection, or an empty text.
std::string WebSocketSession::take_binary(std::string_view bytes, const Answer& reply) {
    const std::span message(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    auto problem = peer_->binary(message);
    reply({});
    return problem.value_or(std::string());
}

// Slow methods call the callback from other threads, possibly after later texts were handled or the socket closed.
Answer WebSocketSession::answer() {
    return [weak = weak_from_this(), send_queue = send_queue_, executor = socket_.get_executor()](std::string text) {
        if (!text.empty()) send_queue->push_text(std::move(text));
        asio::post(executor, [weak] {
            const auto self = weak.lock();
            if (!self) return;
            --self->unanswered_;
            self->send_queue_changed_.cancel();
        });
    };
}

asio::awaitable<void> WebSocketSession::write() {
    error_code error;
    while (!ended_ && !error) {
        const auto message = send_queue_->pop();
        const bool idle = unanswered_ == 0 && inbox_.empty();
        if (!message && close_ && (idle || closes_now_ || close_->code != close_code::going_away)) {
            co_await socket_.async_close(*close_, asio::redirect_error(asio::use_awaitable, error));
            break;
        }
        if (!message) {
            co_await changed(send_queue_changed_);
            continue;
        }
        const bool is_text = message->frame == nullptr;
        const std::array<asio::const_buffer, 2> bytes{is_text ? asio::buffer(message->text)
                                                              : asio::buffer(message->header),
                                                      asio::buffer(message->payload.data(), message->payload.size())};
        socket_.binary(!is_text);
        writing_ = true;
        co_await socket_.async_write(bytes, asio::redirect_error(asio::use_awaitable, error));
        writing_ = false;
        ++(is_text ? state_.counters.texts_sent : state_.counters.frames_sent);
        state_.counters.bytes_sent += asio::buffer_size(bytes);
        if (send_queue_->sent()) peer_->has_room();
    }
    cut(); // also ends a pending read from a lost peer
}

// First call: closes after all answers. Second call: closes without waiting for answers. Third call: disconnects
// without waiting for the client's close frame.
void WebSocketSession::drain() {
    if (!close_) return request_close(close_code::going_away, "the server stops");
    const bool is_third = std::exchange(closes_now_, true);
    send_queue_->close();
    if (writing_ || is_third)
        cut(); // the client does not read or answer, and would not see a close reason
    else
        send_queue_changed_.cancel();
}

void WebSocketSession::send_queue_pushed() {
    if (send_queue_->overflowed()) {
        log_end("the client does not read its answers");
        cut();
    }
    send_queue_changed_.cancel();
}

void WebSocketSession::log_end(std::string_view reason) const {
    const std::chrono::duration<double> open = std::chrono::steady_clock::now() - opened_;
    logging::log_event(
        logging::LogLevel::info, "a WebSocket was closed",
        {{"reason", reason}, {"seconds", open.count()}, {"request", request_}, {"user", user_}, {"remote", remote_}});
}

void WebSocketSession::end() {
    ended_ = true;
    closed_.request_stop();
    cut();
    inbox_changed_.cancel();
    send_queue_changed_.cancel();
}

} // namespace

asio::awaitable<void> websocket_session(beast::tcp_stream stream, HttpRequest upgrade, Client client, OnDrain on_drain,
                                        GatewayState& state, asio::thread_pool& workers) {
    const auto session = std::make_shared<WebSocketSession>(std::move(stream), state, workers);
    co_await session->run(std::move(upgrade), std::move(client), std::move(on_drain));
}

} // namespace server::gateway
