#include "gateway/target.hpp"

#include "ciel/types.hpp"

#include <gtest/gtest.h>

namespace server::gateway {
using namespace ciel;
namespace {

TEST(Target, PathsAreDecodedOnceAndNeverResolved) {
    const struct {
        const char* target;
        const char* path;
    } rows[]{
        {"/", "/"},
        {"/a/b.js", "/a/b.js"},
        {"/a%20b", "/a b"},
        {"/a?x=1", "/a"},
        {"/%2e%2e/etc/passwd", "/../etc/passwd"},
        {"/%252e%252e/x", "/%2e%2e/x"},
        {"/../../x", "/../../x"},
        {"//host/x", "//host/x"},
        {"http://host:80/ws?token=t", "/ws"},
        {"https://host/", "/"},
        {"/caf%C3%A9", "/caf\xc3\xa9"},
    };
    for (const auto& row : rows) {
        const auto target = parse_target(row.target);
        ASSERT_TRUE(target) << row.target;
        EXPECT_EQ(target->path, row.path) << row.target;
    }
}

TEST(Target, TheAuthorityOfAnAbsoluteFormIsItsHost) {
    EXPECT_EQ(authority_of("http://host:80/ws?token=t"), "host:80");
    EXPECT_EQ(authority_of("https://host?x=/"), "host");
    EXPECT_EQ(authority_of("http:///x"), "");
    EXPECT_EQ(authority_of("//host/x"), "");
    EXPECT_EQ(authority_of("/http://host/"), "");
}

TEST(Target, MalformedTargetsAreNothing) {
    const std::string with_null("/a\0b", 4);
    for (const std::string& target :
         {std::string(), std::string("a"), std::string("*"), std::string("/%"), std::string("/%2"), std::string("/%zz"),
          std::string("/%00"), std::string("/%0a"), std::string("/%7f"), std::string("/a\tb"), with_null,
          std::string("http://host"), std::string("http:///x"), std::string("http://?x"), std::string("ftp://host/"),
          std::string("/x?a=%"), std::string("/x?%=a")})
        EXPECT_FALSE(parse_target(target)) << target;
}

TEST(Target, QueriesAreSplitAndDecoded) {
    const auto target = parse_target("/x?token=a%2Bb&empty=&flag&=nameless&token=second");
    ASSERT_TRUE(target);
    EXPECT_EQ(target->query.at("token"), "a+b"); // the first of two `token` parameters counts
    EXPECT_EQ(target->query.at("empty"), "");
    EXPECT_EQ(target->query.at("flag"), "");
    EXPECT_EQ(target->query.count("second"), 0U);
}

TEST(Prefix, IsNormalised) {
    EXPECT_EQ(normal_prefix(""), "");
    EXPECT_EQ(normal_prefix("/"), "");
    EXPECT_EQ(normal_prefix("ciel"), "/ciel");
    EXPECT_EQ(normal_prefix("/a/b//"), "/a/b");
    for (const char* bad : {"/a b", "/a?b", "/a\r\nX: y", "/a\"b", "/%41", "a/../b", "..", "/a/./b", "a//b"})
        EXPECT_THROW((void)normal_prefix(bad), Error) << bad;
}

TEST(Prefix, WorksKeptAndStripped) {
    EXPECT_EQ(below_prefix("/ciel/ws", "/ciel"), "/ws");
    EXPECT_EQ(below_prefix("/ws", "/ciel"), "/ws");
    EXPECT_EQ(below_prefix("/ciel", "/ciel"), "");
    EXPECT_EQ(below_prefix("/ciel/", "/ciel"), "/");
    EXPECT_EQ(below_prefix("/cielo/ws", "/ciel"), "/cielo/ws");
    EXPECT_EQ(below_prefix("/ws", ""), "/ws");
}

} // namespace
} // namespace server::gateway
