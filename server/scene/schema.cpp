#include "scene/schema.hpp"

#include "scene/unknown_members.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <regex>

namespace server::scene {
namespace {

using nlohmann::json;
using Result = std::optional<Violation>;

// Browsers store integers as doubles, which are exact up to this value. It also fits std::int64_t.
constexpr double largest_integer = 9007199254740992.0; // 2^53

bool is_integer(const json& value) {
    if (!value.is_number()) return false;
    const double number = value.get<double>();
    return std::trunc(number) == number && std::abs(number) <= largest_integer;
}

std::string whole_number(const json& schema) {
    if (schema.contains("minimum") && schema.contains("maximum"))
        return "must be a whole number from " + schema["minimum"].dump() + " to " + schema["maximum"].dump();
    return "must be a whole number of at most 2^53";
}

Result check_type(const json& rule, const json& value, const json& schema, const std::string& path) {
    static const std::map<std::string, std::pair<bool (*)(const json&), const char*>> types{
        {"object", {[](const json& v) { return v.is_object(); }, "must be an object"}},
        {"array", {[](const json& v) { return v.is_array(); }, "must be an array"}},
        {"string", {[](const json& v) { return v.is_string(); }, "must be a string"}},
        {"number", {[](const json& v) { return v.is_number(); }, "must be a number"}},
        {"integer", {is_integer, nullptr}},
        {"boolean", {[](const json& v) { return v.is_boolean(); }, "must be true or false"}},
        {"null", {[](const json& v) { return v.is_null(); }, "must be null"}},
    };
    const auto& [matches, reason] = types.at(rule.get<std::string>());
    if (matches(value)) return {};
    return Violation{path, reason ? reason : whole_number(schema)};
}

Result check_enum(const json& rule, const json& value, const json&, const std::string& path) {
    if (std::find(rule.begin(), rule.end(), value) != rule.end()) return {};
    std::string known;
    for (const json& option : rule) known += (known.empty() ? "" : ", ") + option.dump();
    return Violation{path, "must be one of " + known};
}

Result check_const(const json& rule, const json& value, const json&, const std::string& path) {
    if (value == rule) return {};
    return Violation{path, "must be " + rule.dump()};
}

template <class Applies, class Measure, class Compare>
Result check_limit(const json& rule, const json& value, const std::string& path, Applies applies, Measure measure,
                   Compare compare, const char* reason) {
    if (!applies(value) || compare(measure(value), rule.get<double>())) return {};
    return Violation{path, reason + rule.dump()};
}

// `things`: name of one counted item, in the singular.
template <class Applies, class Measure, class Compare>
Result check_size(const json& rule, const json& value, const std::string& path, Applies applies, Measure measure,
                  Compare compare, const char* reason, const char* things) {
    auto violation = check_limit(rule, value, path, applies, measure, compare, reason);
    if (violation) violation->reason += std::string(" ") + things + (rule == 1 ? "" : "s");
    return violation;
}

constexpr auto is_number = [](const json& v) { return v.is_number(); };
constexpr auto is_string = [](const json& v) { return v.is_string(); };
constexpr auto is_array = [](const json& v) { return v.is_array(); };
constexpr auto is_object = [](const json& v) { return v.is_object(); };
constexpr auto number_of = [](const json& v) { return v.get<double>(); };
constexpr auto size_of = [](const json& v) { return static_cast<double>(v.size()); };
// JSON Schema counts code points, that is, all bytes except UTF-8 continuation bytes.
constexpr auto length_of = [](const json& v) {
    const auto& text = v.get_ref<const std::string&>();
    return static_cast<double>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
};

std::string form_of(const std::string& pattern) {
    if (pattern == "^#[0-9a-fA-F]{6}$") return "must be a color of the form #rrggbb";
    if (pattern == "^[A-Za-z0-9_-]{1,64}$") return "must be 1 to 64 of the characters A-Z, a-z, 0-9, _ and -";
    return "must match " + pattern;
}

Result check_pattern(const json& rule, const json& value, const json&, const std::string& path) {
    if (!value.is_string()) return {};
    static std::mutex mutex;
    static std::map<std::string, std::regex> compiled;
    const std::scoped_lock lock(mutex);
    const auto& pattern = rule.get_ref<const std::string&>();
    auto found = compiled.find(pattern);
    if (found == compiled.end()) found = compiled.emplace(pattern, std::regex(pattern, std::regex::ECMAScript)).first;
    if (std::regex_search(value.get_ref<const std::string&>(), found->second)) return {};
    return Violation{path, form_of(pattern)};
}

Result check_items(const json& rule, const json& value, const json&, const std::string& path) {
    if (!value.is_array()) return {};
    for (std::size_t i = 0; i < value.size(); ++i)
        if (auto violation = check_schema(rule, value[i], path + "/" + std::to_string(i))) return violation;
    return {};
}

Result check_required(const json& rule, const json& value, const json&, const std::string& path) {
    if (!value.is_object()) return {};
    for (const json& name : rule)
        if (!value.contains(name.get_ref<const std::string&>()))
            return Violation{pointer_step(path, name.get<std::string>()), "is missing"};
    return {};
}

Result check_properties(const json& rule, const json& value, const json&, const std::string& path) {
    if (!value.is_object()) return {};
    for (const auto& [name, schema] : rule.items()) {
        const auto member = value.find(name);
        if (member == value.end()) continue;
        if (auto violation = check_schema(schema, *member, pointer_step(path, name))) return violation;
    }
    return {};
}

Result check_additional(const json& rule, const json& value, const json& schema, const std::string& path) {
    if (rule == false) return refuse_unknown_members(schema, value, path);
    if (!value.is_object() || !rule.is_object()) return {};
    for (const auto& [name, member] : value.items()) {
        if (is_known_member(schema, name)) continue;
        if (auto violation = check_schema(rule, member, pointer_step(path, name))) return violation;
    }
    return {};
}

// The reason does not repeat a name, because a name may be as long as the request.
Result check_names(const json& rule, const json& value, const json&, const std::string& path) {
    if (!value.is_object()) return {};
    for (const auto& [name, member] : value.items())
        if (const auto violation = check_schema(rule, name, path))
            return Violation{path, "has a member whose name " + violation->reason};
    return {};
}

// Returns the violation of the option that the client meant: the option whose constant "type" matches, or whose
// violation lies inside the value. If there is no such option, the result lists all types or reasons.
Violation best_of(const json& options, const json& value, const std::vector<Violation>& violations,
                  const std::string& path) {
    static const json::json_pointer discriminator("/properties/type/const");
    std::string types, reasons;
    for (std::size_t i = 0; i < violations.size(); ++i) {
        const json& option = resolved(options[i]);
        if (!option.contains(discriminator)) {
            if (violations[i].path != path) return violations[i];
            reasons += (reasons.empty() ? "" : ", or ") + violations[i].reason;
        } else if (!value.is_object() || value.value("type", json()) == option[discriminator]) {
            return violations[i];
        } else {
            types += (types.empty() ? "" : ", ") + option[discriminator].dump();
        }
    }
    return types.empty() ? Violation{path, reasons} : Violation{path + "/type", "must be one of " + types};
}

Result check_options(const json& rule, const json& value, const std::string& path, std::size_t at_most) {
    std::vector<Violation> violations;
    for (const json& option : rule)
        if (auto violation = check_schema(option, value, path)) violations.push_back(*violation);
    const std::size_t fitting = rule.size() - violations.size();
    if (fitting == 0) return best_of(rule, value, violations, path);
    if (fitting > at_most)
        return Violation{path, "matches several forms that exclude each other; keep the members of one form"};
    return {};
}

using Check = Result (*)(const json& rule, const json& value, const json& schema, const std::string& path);

// The checks by keyword, in the order in which violations are reported.
const std::vector<std::pair<std::string, Check>>& checks() {
    static const std::vector<std::pair<std::string, Check>> table{
        {"type", check_type},
        {"const", check_const},
        {"enum", check_enum},
        {"minimum",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_limit(r, v, p, is_number, number_of, std::greater_equal<>(), "must be at least ");
         }},
        {"maximum",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_limit(r, v, p, is_number, number_of, std::less_equal<>(), "must be at most ");
         }},
        {"exclusiveMinimum",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_limit(r, v, p, is_number, number_of, std::greater<>(), "must be more than ");
         }},
        {"exclusiveMaximum",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_limit(r, v, p, is_number, number_of, std::less<>(), "must be less than ");
         }},
        {"minLength",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_size(r, v, p, is_string, length_of, std::greater_equal<>(), "must have at least ",
                               "character");
         }},
        {"maxLength",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_size(r, v, p, is_string, length_of, std::less_equal<>(), "must have at most ", "character");
         }},
        {"minItems",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_size(r, v, p, is_array, size_of, std::greater_equal<>(), "must have at least ", "item");
         }},
        {"maxItems",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_size(r, v, p, is_array, size_of, std::less_equal<>(), "must have at most ", "item");
         }},
        {"maxProperties",
         [](const json& r, const json& v, const json&, const std::string& p) {
             return check_size(r, v, p, is_object, size_of, std::less_equal<>(), "must have at most ", "member");
         }},
        {"pattern", check_pattern},
        {"propertyNames", check_names},
        {"required", check_required},
        {"properties", check_properties},
        {"additionalProperties", check_additional},
        {"items", check_items},
        {"anyOf", [](const json& r, const json& v, const json&,
                     const std::string& p) { return check_options(r, v, p, r.size()); }},
        {"oneOf",
         [](const json& r, const json& v, const json&, const std::string& p) { return check_options(r, v, p, 1); }},
    };
    return table;
}

} // namespace

std::optional<Violation> check_schema(const json& schema, const json& value, const std::string& path) {
    const json& rules = resolved(schema);
    for (const auto& [keyword, check] : checks()) {
        const auto rule = rules.find(keyword);
        if (rule == rules.end()) continue;
        if (auto violation = check(*rule, value, rules, path)) return violation;
    }
    return {};
}

std::vector<std::string> schema_keywords() {
    std::vector<std::string> names{"$ref"};
    for (const auto& [keyword, check] : checks()) names.push_back(keyword);
    return names;
}

} // namespace server::scene
