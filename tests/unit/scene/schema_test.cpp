// The schema validator against valijson, and against the contract's schemas.
#include "random_json.hpp"
#include "scene/schema.hpp"

#include <gtest/gtest.h>
#include <set>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

namespace server::scene {
using namespace ciel;
namespace {

using nlohmann::json;

const std::set<std::string> annotations{"description", "default",    "format",     "x-document",
                                        "x-key",       "x-optional", "x-patch-of", "x-shared"};

// Calls `visit` for a schema and every schema nested in it.
template <class Visit>
void walk(const json& schema, const Visit& visit) {
    visit(schema);
    for (const char* list : {"anyOf", "oneOf"})
        if (schema.contains(list))
            for (const json& option : schema[list]) walk(option, visit);
    for (const char* inner : {"items", "additionalProperties"})
        if (schema.contains(inner) && schema[inner].is_object()) walk(schema[inner], visit);
    if (schema.contains("properties"))
        for (const json& property : schema["properties"]) walk(property, visit);
}

TEST(schema, every_keyword_of_the_contract_is_understood) {
    const auto known = schema_keywords();
    const auto check = [&](const json& schema) {
        for (const auto& [keyword, rule] : schema.items())
            EXPECT_TRUE(annotations.contains(keyword) || std::count(known.begin(), known.end(), keyword) == 1)
                << keyword << " in " << schema;
    };
    for (const json& schema : contract()["components"]["schemas"]) walk(schema, check);
    for (const json& method : contract()["methods"]) {
        for (const json& param : method["params"]) walk(param["schema"], check);
        walk(method["result"]["schema"], check);
    }
}

TEST(schema, one_of_is_exactly_one_and_any_of_is_at_least_one) {
    const json forms = json::parse(R"([{"type": "number"}, {"type": "integer"}])");
    EXPECT_FALSE(check_schema({{"oneOf", forms}}, 1.5));
    EXPECT_TRUE(check_schema({{"oneOf", forms}}, 1)) << "both";
    EXPECT_TRUE(check_schema({{"oneOf", forms}}, "1")) << "neither";
    EXPECT_FALSE(check_schema({{"anyOf", forms}}, 1));
}

// Independent validator for comparison. It resolves only local references, so the contract is its root document.
class Valijson {
public:
    explicit Valijson(const std::string& name) {
        document_ = contract();
        document_["$ref"] = "#/components/schemas/" + name;
        valijson::SchemaParser parser;
        parser.populateSchema(valijson::adapters::NlohmannJsonAdapter(document_), schema_);
    }
    bool accepts(const json& value) {
        valijson::Validator validator;
        return validator.validate(schema_, valijson::adapters::NlohmannJsonAdapter(value), nullptr);
    }

private:
    json document_;
    valijson::Schema schema_;
};

// Replaces, removes or adds a value at a random place in the document.
void mutate(json& value, test::RandomJson& random) {
    if (value.is_structured() && !value.empty() && random.pick(5) != 0) {
        auto inner = value.begin();
        std::advance(inner, random.pick(static_cast<int>(value.size())));
        if (random.pick(6) == 0)
            value.erase(inner);
        else
            mutate(*inner, random);
    } else if (value.is_object() && random.pick(2) == 0) {
        value["extra"] = random.value(1);
    } else if (value.is_number() && random.pick(2) == 0) {
        value = random.pick(2) == 0 ? -1.5 : 1e6;
    } else {
        const json replacements{nullptr,
                                "",
                                "#aabbcc",
                                "slice",
                                0,
                                1,
                                0.5,
                                -3,
                                true,
                                json::array(),
                                json::array({1, 2}),
                                json::array({1, 2, 3}),
                                json::object()};
        value = replacements[static_cast<std::size_t>(random.pick(static_cast<int>(replacements.size())))];
    }
}

TEST(schema, agrees_with_valijson_on_mutated_scenes) {
    const json seed = json::parse(R"({
        "dataset": "d", "time": 2.5, "background": "#102030", "annotations": {"legend": false, "title": "t", "scale": 2},
        "camera": {"position": [1, 2, 3], "target": [4, 5, 6], "up": [0, 1, 0], "fov": 45, "parallel": true, "parallel_height": 7},
        "layers": {
            "i": {"type": "iso", "order": 4, "visible": false, "opacity": 0.5, "array": "U:x", "values": [1, 2], "smooth": false,
                  "color": {"array": "p", "map": "gray", "range": [3, 4], "solid": "#ff0080"}},
            "z": {"type": "slice", "order": 3, "axis": "z", "value": -2},
            "b": {"type": "surface", "order": 1, "groups": ["wall", "inlet"]},
            "o": {"type": "outline", "order": 1, "color": {"range": null}}}})");
    Valijson other("Scene");
    const json& schema = contract()["components"]["schemas"]["Scene"];
    ASSERT_FALSE(check_schema(schema, seed));
    ASSERT_TRUE(other.accepts(seed));
    test::RandomJson random(3);
    int accepted = 0, refused = 0;
    for (int i = 0; i < 3000; ++i) {
        json value = seed;
        for (int k = random.pick(3); k >= 0; --k) mutate(value, random);
        const auto violation = check_schema(schema, value);
        ++(violation ? refused : accepted);
        EXPECT_EQ(!violation, other.accepts(value))
            << value << (violation ? violation->path + " " + violation->reason : " accepted");
    }
    EXPECT_GT(accepted, 100);
    EXPECT_GT(refused, 100);
}

TEST(schema, whole_numbers_fit_a_double_and_an_int64) {
    const json schema{{"type", "integer"}};
    EXPECT_FALSE(check_schema(schema, 3.0));
    EXPECT_FALSE(check_schema(schema, -9007199254740992.0));
    EXPECT_TRUE(check_schema(schema, 3.5));
    EXPECT_TRUE(check_schema(schema, 1e300));
    EXPECT_TRUE(check_schema(schema, 18446744073709551615U));
}

TEST(schema, lengths_count_code_points) {
    const json schema{{"type", "string"}, {"maxLength", 3}};
    EXPECT_FALSE(check_schema(schema, "äöü"));
    EXPECT_TRUE(check_schema(schema, "äöüß"));
}

} // namespace
} // namespace server::scene
