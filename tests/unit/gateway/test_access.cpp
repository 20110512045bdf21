#include "gateway/access.hpp"

#include "ciel/types.hpp"

#include <gtest/gtest.h>
#include <set>

namespace server::gateway {
using namespace ciel;
namespace {

TEST(Host, LoopbackTakesLocalNamesOnly) {
    AccessRules rules;
    rules.allowed_hosts = {"viewer.example.org", "other.example.org:8443"};
    const struct {
        const char* host;
        bool allowed;
    } rows[]{
        {"localhost", true},
        {"localhost:8080", true},
        {"LOCALHOST:8080", true},
        {"127.0.0.1:1", true},
        {"127.0.0.5:18096", true},
        {"127.evil.example", false},
        {"[::1]:8080", true},
        {"viewer.example.org", true},
        {"viewer.example.org:444", true},
        {"other.example.org:8443", true},
        {"other.example.org", false},
        {"", true},
        {"evil.example", false},
        {"localhost.evil.example", false},
        {"127.0.0.1.evil.example:8080", false},
        {"[::1].evil.example", false},
        {"[::2]", false},
        {"::1", false},
        {"[", false},
        {":8080", false},
    };
    for (const auto& row : rows) EXPECT_EQ(host_allowed(rules, row.host), row.allowed) << row.host;
}

TEST(Host, ElsewhereOnlyAListRestricts) {
    AccessRules rules;
    rules.loopback = false;
    EXPECT_TRUE(host_allowed(rules, "anything.example"));
    rules.allowed_hosts = {"viewer.example.org"};
    EXPECT_FALSE(host_allowed(rules, "anything.example"));
    EXPECT_TRUE(host_allowed(rules, "viewer.example.org:80"));
}

TEST(Origin, OwnAndListedOnesPass) {
    AccessRules rules;
    rules.origins = {"https://lab.example.org"};
    const struct {
        const char *origin, *host;
        bool allowed;
    } rows[]{
        {"", "localhost:8080", true}, // no Origin: not a browser
        {"http://localhost:8080", "localhost:8080", true},
        {"HTTP://LOCALHOST:8080", "localhost:8080", false}, // browsers send lower case
        {"https://viewer.example", "viewer.example", true}, // the proxy terminates TLS
        {"https://lab.example.org", "localhost:8080", true},
        {"http://lab.example.org", "localhost:8080", false},
        {"http://localhost:9090", "localhost:8080", false},
        {"http://localhost", "localhost:8080", false},
        {"null", "localhost:8080", false},
        {"null", "null", false},
        {"http://", "", false},
        {"http://evil.example", "localhost:8080", false},
        {"http://localhost:8080.evil.example", "localhost:8080", false},
        {"file://localhost:8080", "localhost:8080", false},
    };
    for (const auto& row : rows)
        EXPECT_EQ(origin_allowed(rules, row.origin, row.host), row.allowed) << row.origin << " on " << row.host;
}

TEST(Token, IsFoundInHeaderQueryAndCookie) {
    AccessRules rules;
    rules.cookie_name = "ciel_token_80";
    const auto presented = [&](const char* authorization, const char* target, const char* cookie) {
        Request request;
        request.authorization = authorization;
        request.cookie = cookie;
        return presented_token(rules, request, *parse_target(target));
    };
    EXPECT_EQ(presented("Bearer abc", "/", ""), "abc");
    EXPECT_EQ(presented("bearer  abc ", "/", ""), "abc");
    EXPECT_EQ(presented("Basic abc", "/", ""), "");
    EXPECT_EQ(presented("Bearer ", "/", ""), "");
    EXPECT_EQ(presented("", "/?token=q", "ciel_token_80=c"), "q");
    EXPECT_EQ(presented("Bearer b", "/?token=q", "ciel_token_80=c"), "b");
    EXPECT_EQ(presented("", "/", "x=y; ciel_token_80=c"), "c");
    EXPECT_EQ(presented("", "/", ""), "");
}

TEST(Token, MustBeTheWholeToken) {
    AccessRules rules;
    EXPECT_FALSE(token_allowed(rules, "")) << "a server always has a token";
    rules.token = "0123456789abcdef";
    EXPECT_TRUE(token_allowed(rules, "0123456789abcdef"));
    for (const char* wrong :
         {"", "0", "0123456789abcde", "0123456789abcdeF", "0123456789abcdef0", "0123456789abcdef0123456789abcdef"})
        EXPECT_FALSE(token_allowed(rules, wrong)) << wrong;
}

TEST(Claim, OfTheOwnUserNeedsALocalNameAndNoProxy) {
    AccessRules rules;
    rules.token = "0123456789abcdef";
    rules.cookie_name = "ciel_token_80";
    rules.allowed_hosts = {"viewer.example.org"};
    rules.own_user_enters = true;
    Request own;
    own.host = "localhost:8080";
    own.is_of_own_user = true;
    const auto claim = [&](const Request& request, const char* target = "/rpc") {
        return claim_of(rules, request, *parse_target(target));
    };
    EXPECT_EQ(claim(own), Claim::own_user);
    EXPECT_EQ(claim(own, "/rpc?token=of-a-server-before"), Claim::own_user);
    for (const char* local : {"127.0.0.1:8080", "127.1.2.3", "[::1]:8080", "LOCALHOST"}) {
        own.host = local;
        EXPECT_EQ(claim(own), Claim::own_user) << local;
    }
    for (const char* other : {"viewer.example.org", "", "localhost.evil.example", "[::2]"}) {
        Request request = own;
        request.host = other;
        EXPECT_EQ(claim(request), Claim::none) << other;
        EXPECT_EQ(claim(request, "/rpc?token=0123456789abcdef"), Claim::token) << other;
    }
    Request proxied = own, stranger = own;
    proxied.is_proxied = true;
    stranger.is_of_own_user = false;
    for (const Request& request : {proxied, stranger}) {
        EXPECT_EQ(claim(request), Claim::none);
        EXPECT_EQ(claim(request, "/rpc?token=wrong"), Claim::wrong_token);
        EXPECT_EQ(claim(request, "/rpc?token=0123456789abcdef"), Claim::token);
    }
    rules.own_user_enters = false; // set when the operator passes a token
    EXPECT_EQ(claim(own), Claim::none);
}

TEST(Claim, ProxiesAreKnownByTheirHeaders) {
    for (const char* name : {"Forwarded", "forwarded", "Via", "VIA", "X-Forwarded-For", "x-forwarded-host",
                             "X-Forwarded-Anything", "X-Real-IP"})
        EXPECT_TRUE(is_of_a_proxy(name)) << name;
    for (const char* name : {"", "Host", "Forwarded-For", "X-Forwarded", "Viable", "X-Forward-For"})
        EXPECT_FALSE(is_of_a_proxy(name)) << name;
}

TEST(Token, GeneratedOnesAreLongAndDiffer) {
    std::set<std::string> seen;
    for (int i = 0; i < 100; ++i) {
        const std::string token = generate_token();
        EXPECT_EQ(token.size(), 32U);
        EXPECT_NO_THROW(check_token_form(token));
        EXPECT_TRUE(seen.insert(token).second);
    }
}

TEST(Token, FormIsChecked) {
    EXPECT_NO_THROW(check_token_form("A-good.one_~1"));
    for (const char* bad :
         {"", "short", "has space in it", "semi;colon;here", "quote\"quote\"", "new\nline\nhere", "percent%20here"})
        EXPECT_THROW(check_token_form(bad), Error) << bad;
}

TEST(Cookie, ValuesAreFoundByWholeName) {
    EXPECT_EQ(cookie_value("a=1; b=2;c=3", "a"), "1");
    EXPECT_EQ(cookie_value("a=1; b=2;c=3", "b"), "2");
    EXPECT_EQ(cookie_value("a=1; b=2;c=3", "c"), "3");
    EXPECT_EQ(cookie_value("aa=1; xa=2", "a"), "");
    EXPECT_EQ(cookie_value("a=x=y", "a"), "x=y");
    for (const char* odd : {"", ";", "=", "a", ";;;", "a;", "=1", " ; = ; "})
        EXPECT_EQ(cookie_value(odd, "a"), "") << odd;
}

TEST(Cookie, IsKeptFromScriptsAndOtherSites) {
    AccessRules rules;
    rules.token = "0123456789";
    rules.cookie_name = "ciel_token_80";
    rules.cookie_path = "/ciel/";
    EXPECT_EQ(token_cookie(rules, false), "ciel_token_80=0123456789; Path=/ciel/; HttpOnly; SameSite=Strict");
    EXPECT_EQ(token_cookie(rules, true), token_cookie(rules, false) + "; Secure");
}

TEST(HandshakeKey, IsSixteenBytes) {
    for (const char* key : {"AAAAAAAAAAAAAAAAAAAAAA==", "dGhlIHNhbXBsZSBub25jZQ==", "+/+/+/+/+/+/+/+/+/+/+w=="})
        EXPECT_TRUE(is_handshake_key(key)) << key;
    for (const char* key :
         {"", "AAAA", "AAAAAAAAAAAAAAAAAAAAAA", "AAAAAAAAAAAAAAAAAAAAAAA=", "AAAAAAAAAAAAAAAAAAAAAAAA",
          "AAAAAAAAAAAAAAAAAAAA====", "AAAAAAAAAAAAAAAAAAAAA-==", "AAAAAAAAAAAAAAAAAAAAAAAA=="})
        EXPECT_FALSE(is_handshake_key(key)) << key;
}

TEST(Subprotocol, IsOneOfThoseOffered) {
    for (const char* header : {"ciel.v1", "a, ciel.v1", "ciel.v1,b", " ciel.v1 , ciel.v2"})
        EXPECT_TRUE(offers_subprotocol(header)) << header;
    for (const char* header : {"", "ciel.v2", "ciel.v11", "xciel.v1", "CIEL.V1", "ciel.v1;q=1", ",,"})
        EXPECT_FALSE(offers_subprotocol(header)) << header;
}

} // namespace
} // namespace server::gateway
