// JsonReader: checked access to JSON of files that may be damaged. Errors name the file and the path of the value.
#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace server::store {

[[nodiscard]] nlohmann::json parse_json(std::string_view text, const std::filesystem::path& file);
// Replaces bytes that are not valid UTF-8 by U+FFFD, because names in imported files may contain any bytes.
[[nodiscard]] std::string valid_utf8(const std::string& text);
[[nodiscard]] std::string to_text(const nlohmann::json& json);

// Does not own the document and `file`. Both must outlive the reader. `place`: such as "steps[3].time".
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

    // Throw FileError with the path in the document. refuse_damage() adds that the dataset is damaged.
    [[noreturn]] void refuse(const std::string& what) const;
    [[noreturn]] void refuse_damage(const std::string& what) const;

private:
    [[nodiscard]] std::string place() const;

    const nlohmann::json* value_;
    const std::filesystem::path* file_;
    std::string place_; // path of the value in the document, such as "arrays[2].name"
};

} // namespace server::store
