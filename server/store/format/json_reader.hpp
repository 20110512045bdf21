// JsonReader: checked access to JSON from files that may be damaged. If a member is missing or has a wrong type, the
// functions throw Error. The message has the file and the path of the value in the document.
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
// Returns a copy of `text` in which bytes that are not valid UTF-8 are replaced by U+FFFD. Names in imported files may
// contain any bytes.
[[nodiscard]] std::string valid_utf8(const std::string& text);
[[nodiscard]] std::string to_text(const nlohmann::json& json);

// Does not own the document and `file`. Both must outlive the reader. `place`: path of the value in the document, such
// as "steps[3].time". Error messages contain `file` and `place`.
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

    // Throws FileError: the path in the document and `what`. refuse_damage() adds that the dataset is damaged, and what
    // to do.
    [[noreturn]] void refuse(const std::string& what) const;
    [[noreturn]] void refuse_damage(const std::string& what) const;

private:
    [[nodiscard]] std::string place() const;

    const nlohmann::json* value_;
    const std::filesystem::path* file_;
    std::string place_; // path of the value in the document, such as "arrays[2].name"
};

} // namespace ciel::store
