#include "store/format/json_reader.hpp"

#include "store/files/files.hpp"

#include <cmath>

namespace server::store {

nlohmann::json parse_json(std::string_view text, const std::filesystem::path& file) {
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::exception&) {
        store::refuse(file, "is not valid JSON; the dataset is damaged: restore the file or import the data again");
    }
}

std::string valid_utf8(const std::string& text) {
    return nlohmann::json::parse(nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace))
        .get<std::string>();
}

std::string to_text(const nlohmann::json& json) {
    // Writes ASCII only, because python3-zarr 2.13 decodes attributes as ASCII.
    return json.dump(1, ' ', true, nlohmann::json::error_handler_t::replace) + "\n";
}

std::string JsonReader::place() const { return place_.empty() ? "the document" : "'" + place_ + "'"; }
void JsonReader::refuse(const std::string& what) const { store::refuse(*file_, place() + " " + what); }
void JsonReader::refuse_damage(const std::string& what) const { store::refuse_damage(*file_, place() + " " + what); }

JsonReader JsonReader::at(const char* key) const {
    if (auto member = find(key)) return *member;
    refuse_damage(std::string("lacks '") + key + "'");
}

std::optional<JsonReader> JsonReader::find(const char* key) const {
    if (!value_->is_object()) refuse_damage("must be an object");
    const auto member = value_->find(key);
    if (member == value_->end() || member->is_null()) return std::nullopt;
    return JsonReader(*member, *file_, place_.empty() ? key : place_ + "." + key);
}

std::vector<JsonReader> JsonReader::items() const {
    if (!value_->is_array()) refuse_damage("must be a list");
    std::vector<JsonReader> result;
    result.reserve(value_->size());
    for (const auto& item : *value_)
        result.emplace_back(item, *file_, place_ + "[" + std::to_string(result.size()) + "]");
    return result;
}

std::vector<std::pair<std::string, JsonReader>> JsonReader::members() const {
    if (!value_->is_object()) refuse_damage("must be an object");
    std::vector<std::pair<std::string, JsonReader>> result;
    for (const auto& [key, member] : value_->items())
        result.emplace_back(key, JsonReader(member, *file_, place_.empty() ? key : place_ + "." + key));
    return result;
}

double JsonReader::number() const {
    if (!value_->is_number()) refuse_damage("must be a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) refuse_damage("must be a finite number");
    return number;
}

std::uint64_t JsonReader::count() const {
    if (!value_->is_number_unsigned()) refuse_damage("must be a whole number, not negative");
    return value_->get<std::uint64_t>();
}

std::string JsonReader::text() const {
    if (!value_->is_string()) refuse_damage("must be a string");
    return value_->get<std::string>();
}

bool JsonReader::flag() const {
    if (!value_->is_boolean()) refuse_damage("must be true or false");
    return value_->get<bool>();
}

} // namespace server::store
