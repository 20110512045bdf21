// HTTP requests and responses as plain data, without Beast. Routes use only these types.
#pragma once

#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace server::gateway {

struct Request {
    std::string method; // such as "GET"; HEAD is answered like GET, but without the body
    std::string target; // as sent: "/rpc?token=..."
    std::string host;   // authority of an absolute-form target, else the Host header
    std::string origin, authorization, cookie, content_type, accept_encoding, if_none_match;
    std::string forwarded_for, forwarded_proto;
    std::string body;
    std::string user;    // for logs: name given by a trusted proxy, or the server's user if is_of_own_user; else empty
    std::string remote;  // address and port, for logs
    std::string id;      // made by the server for the log, X-Request-Id and error answers
    std::string address; // address without the port
    bool is_of_own_user = false; // whether the peer is a process of the server's user on this machine
    bool is_proxied = false;     // whether the request has a header that proxies add
    std::chrono::steady_clock::time_point begun = std::chrono::steady_clock::now(); // when the head was complete

    [[nodiscard]] double milliseconds() const { // since `begun`
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begun).count();
    }
};

struct Response {
    unsigned status = 200;
    std::string content_type = "text/plain; charset=utf-8";
    std::string body;
    std::vector<std::pair<std::string, std::string>> headers;
};

// Returns a text/plain response whose body is the sentence and a newline.
[[nodiscard]] Response sentence(unsigned status, std::string text);
[[nodiscard]] Response json(unsigned status, std::string text);

} // namespace server::gateway
