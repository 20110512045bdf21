// HTTP requests and answers byte by byte, including malformed requests.
#include "gateway/http_request.hpp"
#include "running_server.hpp"

#include <gmock/gmock.h>

namespace server::gateway {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Http : public testing::Test {
protected:
    static void SetUpTestSuite() { server_ = std::make_unique<RunningServer>(); }
    static void TearDownTestSuite() { server_.reset(); }

    // Sends a request and returns everything until the server closes. Requests carry the token: the server may find no
    // owner of a socket that the client has closed already.
    static std::string exchange(const std::string& request) {
        Socket socket(*server_);
        socket.send(request);
        socket.end_of_requests();
        return socket.receive_all();
    }

    static std::string request(const std::string& line, const std::string& headers = {}, const std::string& body = {}) {
        return line + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n" + server_->authorization() + headers +
               "\r\n" + body;
    }
    static std::string coded(const std::string& transfer_encoding, const std::string& body = {}) {
        return request("POST /rpc",
                       "Content-Type: application/json\r\nTransfer-Encoding: " + transfer_encoding + "\r\n", body);
    }
    static std::string blank_lines(int count) {
        std::string lines;
        for (int i = 0; i < count; ++i) lines += "\r\n";
        return lines;
    }
    static std::vector<std::string> statuses_of(const std::string& answer) {
        std::vector<std::string> statuses;
        for (auto at = answer.find("HTTP/1.1 "); at != std::string::npos; at = answer.find("HTTP/1.1 ", at + 1))
            statuses.push_back(answer.substr(at + 9, 3));
        return statuses;
    }
    static std::string json_post(const std::string& body, const std::string& headers = {}) {
        return request("POST /rpc",
                       "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n" +
                           headers,
                       body);
    }

    static inline std::unique_ptr<RunningServer> server_;
};

const std::string discover = R"({"jsonrpc":"2.0","id":1,"method":"rpc.discover"})";

TEST_F(Http, AnswersByStatus) {
    const std::string big(2 << 20, 'x');
    const struct {
        const char* name;
        std::string request;
        const char* answer; // start of the answer; empty when the server closes without one
    } rows[]{
        {"alive", request("GET /healthz"), "HTTP/1.1 200"},
        {"below the prefix", request("GET /ciel/healthz"), "HTTP/1.1 200"},
        {"absolute form", request("GET http://localhost/healthz"), "HTTP/1.1 200"},
        {"old version", "GET /healthz HTTP/1.0\r\n\r\n", "HTTP/1.0 200"},
        {"the prefix itself", request("GET /ciel"), "HTTP/1.1 308"},
        {"unknown path", request("GET /nothing"), "HTTP/1.1 404"},
        {"traversal", request("GET /../../etc/passwd"), "HTTP/1.1 404"},
        {"encoded traversal", request("GET /%2e%2e%2f%2e%2e%2fetc/passwd"), "HTTP/1.1 404"},
        {"bad escape", request("GET /%zz"), "HTTP/1.1 400"},
        {"encoded null", request("GET /%00"), "HTTP/1.1 400"},
        {"absolute form of another host", request("GET http://evil.example/healthz"), "HTTP/1.1 403"},
        {"absolute form without a host", request("GET http:///healthz"), "HTTP/1.1 400"},
        {"absolute form of a user after a port", request("GET http://localhost:80@evil.example/healthz"),
         "HTTP/1.1 403"},
        {"absolute form of a host and a port", request("GET http://localhost:80/healthz"), "HTTP/1.1 200"},
        {"absolute form of a user", request("GET http://localhost@evil.example/healthz"), "HTTP/1.1 403"},
        {"a blank line before", "\r\n" + request("GET /healthz"), "HTTP/1.1 200"},
        {"many blank lines before", blank_lines(9) + request("GET /healthz"), "HTTP/1.1 400"},
        {"asterisk form", request("OPTIONS *"), "HTTP/1.1 400"},
        {"other method", request("DELETE /healthz"), "HTTP/1.1 405"},
        {"made-up method", request("BREW /healthz"), "HTTP/1.1 405"},
        {"GET where POST is due", request("GET /rpc"), "HTTP/1.1 405"},
        {"no upgrade", request("GET /ws"), "HTTP/1.1 426"},
        {"CONNECT", request("CONNECT localhost:22"), "HTTP/1.1 400"},
        {"method call", json_post(discover), "HTTP/1.1 200"},
        {"notification", json_post(R"({"jsonrpc":"2.0","method":"rpc.discover"})"), "HTTP/1.1 204"},
        {"chunked",
         request("POST /rpc", "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n",
                 "2\r\n{}\r\n0\r\n\r\n"),
         "HTTP/1.1 200"},
        {"identity", coded("identity"), "HTTP/1.1 400"},
        {"no chunked coding", coded("xchunked"), "HTTP/1.1 400"},
        {"chunked not last", coded("chunked, identity"), "HTTP/1.1 400"},
        {"chunked twice", coded("chunked, chunked"), "HTTP/1.1 400"},
        {"chunked in two lines", coded("chunked\r\nTransfer-Encoding: chunked"), "HTTP/1.1 400"},
        {"not chunked in the second line", coded("chunked\r\nTransfer-Encoding: identity"), "HTTP/1.1 400"},
        {"no coding", coded(""), "HTTP/1.1 400"},
        {"empty codings", coded(", chunked"), "HTTP/1.1 400"},
        {"compressed", coded("gzip, chunked"), "HTTP/1.1 501"},
        {"compressed in two lines", coded("gzip\r\nTransfer-Encoding: chunked"), "HTTP/1.1 501"},
        {"chunked in capitals", coded("Chunked", "2\r\n{}\r\n0\r\n\r\n"), "HTTP/1.1 200"},
        {"chunked in HTTP/1.0",
         "POST /rpc HTTP/1.0\r\nContent-Type: application/json\r\nTransfer-Encoding: chunked\r\n\r\n0\r\n\r\n",
         "HTTP/1.0 400"},
        {"form", request("POST /rpc", "Content-Type: application/x-www-form-urlencoded\r\nContent-Length: 2\r\n", "{}"),
         "HTTP/1.1 415"},
        {"another case and a parameter",
         request("POST /rpc", "Content-Type: Application/JSON ;charset=UTF-8\r\nContent-Length: 2\r\n", "{}"),
         "HTTP/1.1 200"},
        {"a longer type", request("POST /rpc", "Content-Type: application/jsonp\r\nContent-Length: 2\r\n", "{}"),
         "HTTP/1.1 415"},
        {"no type", request("POST /rpc", "Content-Length: 2\r\n", "{}"), "HTTP/1.1 415"},
        {"large body", json_post(big), "HTTP/1.1 413"},
        {"large chunked body",
         request("POST /rpc", "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n",
                 "200000\r\n" + big + "\r\n0\r\n\r\n"),
         "HTTP/1.1 413"},
        {"length without a body", request("POST /rpc", "Content-Length: 99999999999\r\n"), "HTTP/1.1 413"},
        {"length that overflows", request("POST /rpc", "Content-Length: 99999999999999999999999999\r\n"),
         "HTTP/1.1 400"},
        {"negative length", request("POST /rpc", "Content-Length: -1\r\n"), "HTTP/1.1 400"},
        {"two lengths", request("POST /rpc", "Content-Length: 2\r\nContent-Length: 3\r\n", "{}"), "HTTP/1.1 400"},
        {"length and chunks", request("POST /rpc", "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n", "0\r\n\r\n"),
         "HTTP/1.1 400"},
        {"bad chunk size",
         request("POST /rpc", "Content-Type: application/json\r\nTransfer-Encoding: chunked\r\n", "zz\r\n"),
         "HTTP/1.1 400"},
        {"large header", request("GET /", "X: " + std::string(64 << 10, 'x') + "\r\n"), "HTTP/1.1 431"},
        {"long target", request("GET /" + std::string(64 << 10, 'x')), "HTTP/1.1 431"},
        {"header without a colon", request("GET /", "nonsense\r\n"), "HTTP/1.1 400"},
        {"null in a header", request("GET /", std::string("X: a\0b\r\n", 8)), "HTTP/1.1 400"},
        {"other version", "GET / HTTP/9.9\r\n\r\n", "HTTP/1.1 400"},
        {"HTTP/2", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", "HTTP/1.1 400"},
        {"TLS", std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11) + std::string(500, '\x01'),
         "HTTP/1.1 400"},
        {"garbage", std::string(300, '\xff') + "\r\n\r\n", "HTTP/1.1 400"},
        {"no host", "GET / HTTP/1.1\r\n\r\n", "HTTP/1.1 400"},
        {"two hosts", "GET / HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n", "HTTP/1.1 400"},
        {"another's host", "GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n", "HTTP/1.1 403"},
        {"another's origin", json_post(discover, "Origin: http://evil.example\r\n"), "HTTP/1.1 403"},
        {"own origin", json_post(discover, "Origin: http://localhost\r\n"), "HTTP/1.1 200"},
        {"listed origin", json_post(discover, "Origin: https://lab.example.org\r\n"), "HTTP/1.1 200"},
        {"nothing", "", ""},
        {"half a request", "GET / HT", ""},
        {"half a body", request("POST /rpc", "Content-Type: application/json\r\nContent-Length: 9\r\n", "{}"), ""},
    };
    for (const auto& row : rows)
        EXPECT_THAT(exchange(row.request).substr(0, 12), testing::StrEq(row.answer)) << row.name;
    EXPECT_THAT(exchange(request("GET /healthz")), StartsWith("HTTP/1.1 200")) << "it still stands";
}

TEST_F(Http, HeadHasTheHeaderOfGetAndNoBody) {
    const auto without_own = [](std::string answer) { // removes the fields that differ for each request
        for (const char* name : {"Date: ", "X-Request-Id: "}) {
            const auto field = answer.find(name);
            answer.erase(field, answer.find("\r\n", field) + 2 - field);
        }
        return answer;
    };
    const std::string get = without_own(exchange(request("GET /healthz")));
    const std::string head = without_own(exchange(request("HEAD /healthz")));
    EXPECT_EQ(head, get.substr(0, get.find("\r\n\r\n") + 4));
    EXPECT_THAT(get, testing::EndsWith("\r\n\r\nok\n"));
}

TEST_F(Http, ConnectionsAreKeptAndRequestsPipelined) {
    const std::string first = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
    EXPECT_THAT(statuses_of(exchange(first + first + request("GET /nothing"))),
                testing::ElementsAre("200", "200", "404"));
    EXPECT_THAT(statuses_of(exchange(first + "\r\n" + first + "\r\n\r\n" + request("GET /nothing"))),
                testing::ElementsAre("200", "200", "404"));
}

// When client and server may disagree on the end of a body, nothing after it may be read as a request.
TEST_F(Http, NothingIsReadAfterABodyWithoutAnEnd) {
    const std::string hidden = "GET /healthz HTTP/1.1\r\nHost: localhost\r\n\r\n";
    const std::string kept = "POST /rpc HTTP/1.1\r\nHost: localhost\r\nContent-Type: application/json\r\n";
    for (const char* coding : {"identity", "xchunked", "chunked, identity", "gzip"})
        EXPECT_THAT(statuses_of(exchange(kept + "Transfer-Encoding: " + coding + "\r\n\r\n" + hidden)),
                    testing::ElementsAre("400"))
            << coding;
}

TEST_F(Http, AnswersAreDated) {
    for (const std::string& asked : {request("GET /healthz"), request("GET /nothing"), std::string("nonsense\r\n\r\n")})
        EXPECT_THAT(exchange(asked),
                    testing::ContainsRegex("\r\nDate: [A-Z][a-z][a-z], [0-9][0-9] [A-Z][a-z][a-z] 20[0-9][0-9] "
                                           "[0-9][0-9]:[0-9][0-9]:[0-9][0-9] GMT\r\n"));
    EXPECT_EQ(http_date(784'111'777), "Sun, 06 Nov 1994 08:49:37 GMT"); // example of RFC 9110
}

TEST_F(Http, EveryAnswerForbidsFramingAndSniffing) {
    for (const char* path : {"/", "/nothing", "/healthz", "/rpc", "/%zz"}) {
        const std::string answer = exchange(request(std::string("GET ") + path));
        EXPECT_THAT(answer, HasSubstr("X-Content-Type-Options: nosniff\r\n")) << path;
        EXPECT_THAT(answer, HasSubstr("frame-ancestors 'self' https://lab.example.org\r\n")) << path;
        EXPECT_THAT(answer, HasSubstr("Referrer-Policy: no-referrer\r\n")) << path;
    }
    EXPECT_THAT(exchange("garbage\r\n\r\n"), HasSubstr("X-Content-Type-Options: nosniff\r\n"));
}

TEST_F(Http, RefusalsSayWhatIsAllowed) {
    EXPECT_THAT(exchange(request("POST /healthz")), HasSubstr("Allow: GET, HEAD\r\n"));
    EXPECT_THAT(exchange(request("GET /rpc")), HasSubstr("Allow: POST, OPTIONS\r\n"));
    EXPECT_THAT(exchange(request("GET /ciel?token=x")), HasSubstr("Location: /ciel/?token=x\r\n"));
    EXPECT_THAT(exchange("GET / HTTP/1.1\r\nHost: evil.example\r\nConnection: close\r\n\r\n"),
                HasSubstr("--allowed-host"));
}

TEST_F(Http, OnlyListedOriginsMayRead) {
    const std::string listed =
        exchange(request("OPTIONS /rpc", "Origin: https://lab.example.org\r\nAccess-Control-Request-Method: POST\r\n"));
    EXPECT_THAT(listed, StartsWith("HTTP/1.1 204"));
    EXPECT_THAT(listed, HasSubstr("Access-Control-Allow-Origin: https://lab.example.org\r\n"));
    const std::string other =
        exchange(request("OPTIONS /rpc", "Origin: https://evil.example\r\nAccess-Control-Request-Method: POST\r\n"));
    EXPECT_THAT(other, StartsWith("HTTP/1.1 403"));
    EXPECT_THAT(other, Not(HasSubstr("Access-Control-Allow-Origin")));
}

TEST_F(Http, GoesOnAfter100Continue) {
    const std::string answer = exchange(json_post(discover, "Expect: 100-continue\r\n"));
    EXPECT_THAT(answer, StartsWith("HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 200"));
}

TEST_F(Http, BytesMayComeOneByOne) {
    Socket socket(*server_);
    for (const char byte : request("GET /healthz")) {
        ASSERT_TRUE(socket.send({byte}));
        std::this_thread::sleep_for(std::chrono::microseconds(200));
    }
    EXPECT_EQ(socket.receive(12), "HTTP/1.1 200");
}

} // namespace
} // namespace server::gateway
