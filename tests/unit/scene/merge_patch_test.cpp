#include "random_json.hpp"
#include "scene/scene.hpp"

#include <gtest/gtest.h>

namespace server::scene {
using namespace ciel;
namespace {

using nlohmann::json;

// Test cases of RFC 7396, appendix A.
struct Row {
    const char *original, *patch, *result;
};
constexpr Row appendix_a[] = {
    {R"({"a":"b"})", R"({"a":"c"})", R"({"a":"c"})"},
    {R"({"a":"b"})", R"({"b":"c"})", R"({"a":"b","b":"c"})"},
    {R"({"a":"b"})", R"({"a":null})", R"({})"},
    {R"({"a":"b","b":"c"})", R"({"a":null})", R"({"b":"c"})"},
    {R"({"a":["b"]})", R"({"a":"c"})", R"({"a":"c"})"},
    {R"({"a":"c"})", R"({"a":["b"]})", R"({"a":["b"]})"},
    {R"({"a":{"b":"c"}})", R"({"a":{"b":"d","c":null}})", R"({"a":{"b":"d"}})"},
    {R"({"a":[{"b":"c"}]})", R"({"a":[1]})", R"({"a":[1]})"},
    {R"(["a","b"])", R"(["c","d"])", R"(["c","d"])"},
    {R"({"a":"b"})", R"(["c"])", R"(["c"])"},
    {R"({"a":"foo"})", R"(null)", R"(null)"},
    {R"({"a":"foo"})", R"("bar")", R"("bar")"},
    {R"({"e":null})", R"({"a":1})", R"({"e":null,"a":1})"},
    {R"([1,2])", R"({"a":"b","c":null})", R"({"a":"b"})"},
    {R"({})", R"({"a":{"bb":{"ccc":null}}})", R"({"a":{"bb":{}}})"},
};

TEST(merge_patch, rfc_7396_appendix_a) {
    for (const Row& row : appendix_a)
        EXPECT_EQ(merge_patch(json::parse(row.original), json::parse(row.patch)), json::parse(row.result))
            << row.original << " patched by " << row.patch;
}

TEST(merge_patch, diff_leads_from_one_document_to_another) {
    test::RandomJson random(7);
    for (int i = 0; i < 5000; ++i) {
        const json from = random.object(3), to = random.object(3);
        EXPECT_EQ(merge_patch(from, diff(from, to)), to) << from << " -> " << to;
    }
}

TEST(merge_patch, diff_of_equal_documents_is_empty) {
    test::RandomJson random(11);
    for (int i = 0; i < 500; ++i) {
        const json document = random.object(3);
        EXPECT_EQ(diff(document, document), json::object());
    }
}

TEST(merge_patch, diff_names_only_what_differs) {
    const json from{{"same", {{"x", 1}}}, {"camera", {{"fov", 30}, {"up", {0, 0, 1}}}}, {"gone", 1}};
    const json to{{"same", {{"x", 1}}}, {"camera", {{"fov", 40}, {"up", {0, 0, 1}}}}};
    EXPECT_EQ(diff(from, to), json::parse(R"({"camera":{"fov":40},"gone":null})"));
}

} // namespace
} // namespace server::scene
