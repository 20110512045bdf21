// Checked access to JSON of unknown origin: every miss is an Error that names the file and the place in it.
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
// Bytes that are not UTF-8 become U+FFFD: what a file format hands over as a name may hold anything.
[[nodiscard]] std::string valid_utf8(const std::string& text);
[[nodiscard]] std::string to_text(const nlohmann::json& json);

// Borrows the document; `file` and `place` are for the sentences.
class JsonReader {
public:
    JsonReader(const nlohmann::json& value, const std::filesystem::path& file, std::string place = {})
        : value_(&value), file_(&file), place_(std::move(place)) {}

    [[nodiscard]] JsonReader at(const char* key) const;
    [[nodiscard]] std::optional<JsonReader> find(const char* key) const; // null counts as absent
    [[nodiscard]] std::vector<JsonReader> items() const;
    [[nodiscard]] std::vector<std::pair<std::string, JsonReader>> members() const;

    [[nodiscard]] double number() const; // finite
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
