// JsonReader: checked access to JSON of unknown origin. A missing member or a wrong type throws Error that names the
// file and the place in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ciel::store {

// Throws Error when `text` is not JSON.
[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::filesystem::path& file);
// Returns `text` with bytes that are not UTF-8 replaced by U+FFFD. Names in imported files may hold any bytes.
[[nodiscard]] std::string valid_utf8(const std::string& text);
[[nodiscard]] std::string to_text(const nlohmann::json& json);

// Refers to the document and to `file`, which must outlive it. Messages name `file` and `place` ("steps[3].time").
class JsonReader {
public:
    JsonReader(const nlohmann::json& value, const std::filesystem::path& file, std::string place = {})
        : value_(&value), file_(&file), place_(std::move(place)) {}

    [[nodiscard]] JsonReader at(const char* key) const;
    [[nodiscard]] std::optional<JsonReader> find(const char* key) const; // nullopt if the member is absent or null
    [[nodiscard]] std::vector<JsonReader> items() const;
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;

    [[nodiscard]] double number() const; // throws Error unless the value is a finite number
    [[nodiscard]] std::uint64_t count() const;
    [[nodiscard]] std::string text() const;
    [[nodiscard]] bool flag() const;
    [[nodiscard]] bool is_object() const { return value_->is_object(); }

    [[noreturn]] void refuse(const std::string& what) const;

private:
    const nlohmann::json* value_;
    const std::filesystem::path* file_;
    std::string place_;
};

} // namespace ciel::store
