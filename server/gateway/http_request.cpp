#include "gateway/http_request.hpp"

#include "gateway/access.hpp"
#include "gateway/framing.hpp"
#include "gateway/target.hpp"

#include <algorithm>
#include <array>
#include <boost/beast/http/error.hpp>

namespace server::gateway {
namespace {

namespace http = boost::beast::http;

std::string_view view_of(boost::string_view view) { return {view.data(), view.size()}; }
std::string text_of(boost::string_view view) { return std::string(view_of(view)); }

// Joins all lines of a list field by commas (RFC 9110, 5.3).
template <typename Name>
std::string joined(const HttpRequest& message, Name name) {
    std::string all;
    const auto [first, last] = message.equal_range(name);
    for (auto field = first; field != last; ++field) {
        if (field != first) all += ", ";
        all += view_of(field->value());
    }
    return all;
}

} // namespace

Request plain_request(const HttpRequest& message) {
    Request request;
    request.method = text_of(message.method_string());
    request.target = text_of(message.target());
    const auto authority = authority_of(request.target); // of an absolute-form target; replaces Host (RFC 9112, 3.2.2)
    request.host = authority.empty() ? text_of(message[http::field::host]) : std::string(authority);
    request.origin = text_of(message[http::field::origin]);
    request.authorization = text_of(message[http::field::authorization]);
    request.cookie = text_of(message[http::field::cookie]);
    request.content_type = text_of(message[http::field::content_type]);
    request.accept_encoding = joined(message, http::field::accept_encoding);
    request.if_none_match = text_of(message[http::field::if_none_match]);
    request.forwarded_for = joined(message, "X-Forwarded-For");
    request.forwarded_proto = text_of(message["X-Forwarded-Proto"]);
    request.user = text_of(message["X-Forwarded-User"]);
    request.is_proxied = std::any_of(message.begin(), message.end(),
                                     [](const auto& field) { return is_of_a_proxy(view_of(field.name_string())); });
    return request;
}

std::optional<Response> refused_bytes(const boost::system::error_code& error) {
    if (error == http::error::header_limit)
        return sentence(
            431, "The header of the request is too large; make it smaller (server.info has the limit header_bytes).");
    if (error == http::error::body_limit)
        return sentence(
            413, "The body of the request is too large; make it smaller (server.info has the limit message_bytes).");
    if (error == http::error::end_of_stream || error == http::error::partial_message) return std::nullopt;
    if (error.category() == http::make_error_code(http::error::bad_method).category())
        return sentence(400, "The request is not valid HTTP/1.1: " + error.message() + "; correct the request.");
    return std::nullopt;
}

std::optional<Response> refused_head(const HttpRequest& message) {
    if (message.version() >= 11 && message.count(http::field::host) != 1)
        return sentence(400, "HTTP/1.1 needs exactly one Host header.");
    if (message.count(http::field::transfer_encoding) == 0) return std::nullopt;
    if (message.version() < 11)
        return sentence(400, "An HTTP/1.0 request must not have a Transfer-Encoding; use HTTP/1.1.");
    switch (framing_of(joined(message, http::field::transfer_encoding))) {
    case Framing::readable:
        return std::nullopt;
    case Framing::unknown_coding:
        return sentence(501, "The transfer coding is not supported; use chunked.");
    case Framing::malformed:
        break;
    }
    return sentence(400, "The last transfer coding of a request must be chunked, and chunked must occur once.");
}

std::optional<Response> refused_handshake(const HttpRequest& message) {
    if (!offers_subprotocol(joined(message, http::field::sec_websocket_protocol)))
        return sentence(400, "This WebSocket needs the subprotocol ciel.v1 (Sec-WebSocket-Protocol).");
    if (view_of(message[http::field::sec_websocket_version]) != "13") {
        Response refusal = sentence(426, "The version of the WebSocket protocol must be 13 (Sec-WebSocket-Version).");
        refusal.headers.emplace_back("Sec-WebSocket-Version", "13"); // RFC 6455, 4.4
        return refusal;
    }
    if (!is_handshake_key(view_of(message[http::field::sec_websocket_key])))
        return sentence(400, "Sec-WebSocket-Key must be 16 bytes in base64.");
    return std::nullopt;
}

std::string http_date(std::time_t time) {
    static constexpr std::array days{"Sun", "Mon", "Tue", "Wed", "Thu", "Fri", "Sat"};
    static constexpr std::array months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                       "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
    std::tm utc{};
    ::gmtime_r(&time, &utc);
    const auto two = [](int number) { return std::string(number < 10 ? "0" : "") + std::to_string(number); };
    return std::string(days.at(static_cast<std::size_t>(utc.tm_wday))) + ", " + two(utc.tm_mday) + " " +
           months.at(static_cast<std::size_t>(utc.tm_mon)) + " " + std::to_string(utc.tm_year + 1900) + " " +
           two(utc.tm_hour) + ":" + two(utc.tm_min) + ":" + two(utc.tm_sec) + " GMT";
}

} // namespace server::gateway
