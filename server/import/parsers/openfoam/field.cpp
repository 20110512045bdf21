#include "import/parsers/openfoam/field.hpp"

#include "ciel/types.hpp"
#include "import/parsers/openfoam/reader.hpp"

#include <algorithm>
#include <regex>

namespace server::importer {

namespace {

class FieldParser {
public:
    FieldParser(std::string_view bytes, const std::string& file, std::size_t most) : reader_(bytes, file), most_(most) {
        field_.components = foam_field_components(reader_.format().class_name);
        if (field_.components == 0)
            reader_.fail("is of the class " + reader_.format().class_name + ", which is not a field of cells,");
        field_.is_single_precision = reader_.format().is_binary && reader_.format().scalar_bytes == 4;
    }

    FoamField run() {
        bool has_cells = false;
        while (!reader_.at_end()) {
            bool is_quoted = false;
            const std::string_view key = reader_.name(is_quoted);
            if (key == "internalField" || key == "value") {
                std::optional<FoamValues> values = read_values();
                if (!values) reader_.fail("has cell values that are neither uniform nor nonuniform");
                field_.cells = std::move(*values);
                has_cells = true;
            } else if (key == "boundaryField") {
                read_conditions();
                continue;
            }
            reader_.skip_entry();
        }
        if (!has_cells) reader_.fail("has no internalField");
        return std::move(field_);
    }

private:
    std::optional<FoamValues> read_values() {
        const char next = reader_.peek();
        if (next != 'u' && next != 'n') return std::nullopt;
        const std::string_view kind = reader_.word();
        if (kind == "uniform") return FoamValues{true, read_tuple()};
        if (kind != "nonuniform") return std::nullopt;
        FoamValues values{false, reader_.numbers(field_.components, most_)};
        return values;
    }

    std::vector<double> read_tuple() {
        std::vector<double> numbers;
        if (reader_.peek() == '(')
            numbers = reader_.numbers(1, 0);
        else
            numbers.push_back(reader_.number());
        if (numbers.size() != static_cast<std::size_t>(field_.components))
            reader_.fail("has a uniform value with " + std::to_string(numbers.size()) + " numbers instead of " +
                         std::to_string(field_.components) + ", the number of components of the field,");
        return numbers;
    }

    void read_conditions() {
        reader_.expect('{');
        while (!reader_.accept('}')) {
            FoamCondition condition;
            condition.name = reader_.name(condition.is_pattern);
            if (reader_.peek() != '{') { // an entry of boundaryField itself, not a patch
                reader_.skip_entry();
                continue;
            }
            reader_.expect('{');
            while (!reader_.accept('}')) read_condition_entry(condition);
            field_.conditions.push_back(std::move(condition));
        }
        static_cast<void>(reader_.accept(';'));
    }

    void read_condition_entry(FoamCondition& condition) {
        bool is_quoted = false;
        const std::string_view key = reader_.name(is_quoted);
        if (key == "type")
            condition.type = reader_.name(is_quoted);
        else if (key == "value")
            condition.value = read_values();
        reader_.skip_entry();
    }

    FoamReader reader_;
    std::size_t most_;
    FoamField field_;
};

// In bytes. std::regex_match recurses once per character, so that longer names could overflow the stack.
constexpr std::size_t longest_name = 256;

bool matches(const std::string& pattern, const std::string& name) {
    if (pattern.size() > longest_name || name.size() > longest_name) return false;
    try {
        return std::regex_match(name, std::regex(pattern, std::regex::extended));
    } catch (const std::regex_error&) {
        return false;
    }
}

} // namespace

const FoamCondition* FoamField::condition(const std::string& patch, const std::vector<std::string>& groups) const {
    const FoamCondition *by_group = nullptr, *by_pattern = nullptr;
    for (const FoamCondition& condition : conditions) {
        if (condition.is_pattern) {
            if (matches(condition.name, patch)) by_pattern = &condition;
        } else if (condition.name == patch) {
            return &condition;
        } else if (std::find(groups.begin(), groups.end(), condition.name) != groups.end()) {
            by_group = &condition;
        }
    }
    return by_group != nullptr ? by_group : by_pattern;
}

int foam_field_components(std::string_view class_name) {
    constexpr std::string_view internal = "::Internal";
    if (class_name.ends_with(internal)) class_name.remove_suffix(internal.size());
    if (!class_name.starts_with("vol") || !class_name.ends_with("Field")) return 0;
    std::string type(class_name.substr(3, class_name.size() - 8));
    if (type.empty()) return 0;
    type[0] = static_cast<char>(type[0] - 'A' + 'a');
    return foam_components(type);
}

FoamField parse_foam_field(std::string_view bytes, const std::string& file, std::size_t most) {
    return FieldParser(bytes, file, most).run();
}

} // namespace server::importer
