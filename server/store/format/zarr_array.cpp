#include "store/format/zarr_array.hpp"

#include "store/files/files.hpp"
#include "store/format/json_reader.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace server::store {
namespace {

struct TypeRow {
    ElementType type;
    const char* name;
    std::size_t bytes;
};
constexpr std::array type_table{TypeRow{ElementType::u1, "|u1", 1}, TypeRow{ElementType::u4, "<u4", 4},
                                TypeRow{ElementType::u8, "<u8", 8}, TypeRow{ElementType::i8, "<i8", 8},
                                TypeRow{ElementType::f4, "<f4", 4}, TypeRow{ElementType::f8, "<f8", 8}};

const TypeRow& row(ElementType type) {
    return *std::find_if(type_table.begin(), type_table.end(), [&](const TypeRow& r) { return r.type == type; });
}

ElementType parse_type(const JsonReader& value) {
    const std::string name = value.text();
    for (const TypeRow& r : type_table)
        if (name == r.name) return r.type;
    value.refuse("is '" + name + "', which is not a type of a CIEL dataset; use |u1, <u4, <u8, <i8, <f4 or <f8");
}

std::vector<std::uint64_t> parse_extents(const JsonReader& value) {
    std::vector<std::uint64_t> extents;
    for (const JsonReader& item : value.items()) extents.push_back(item.count());
    if (extents.empty() || extents.size() > 3) value.refuse_damage("must have one to three entries");
    return extents;
}

void check_version(const JsonReader& document) {
    if (document.at("zarr_format").count() != 2) document.at("zarr_format").refuse("must be 2");
}

// zarr-python 3.0 writes NaN without quotes, which is not valid JSON. Zarr 2 requires the quotes.
std::string with_nan_as_text(std::string text) {
    constexpr std::string_view key = "\"fill_value\"", bare = "NaN", blank = " \t\r\n";
    const auto found = text.find(key);
    if (found == std::string::npos) return text;
    const auto colon = text.find_first_not_of(blank, found + key.size());
    if (colon == std::string::npos || text[colon] != ':') return text;
    const auto value = text.find_first_not_of(blank, colon + 1);
    if (value != std::string::npos && text.compare(value, bare.size(), bare) == 0)
        text.replace(value, bare.size(), "\"NaN\"");
    return text;
}

} // namespace

std::size_t element_bytes(ElementType type) { return row(type).bytes; }

std::size_t ZarrArray::chunk_bytes(const std::filesystem::path& file) const {
    // An empty array has no chunk file. It declares a chunk of one element only because Zarr forbids 0.
    if (std::find(shape.begin(), shape.end(), 0U) != shape.end()) return 0;
    std::uint64_t bytes = element_bytes(type);
    for (const std::uint64_t extent : chunks) {
        if (extent > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) / bytes)
            refuse(file, "declares a chunk of more than 2^63 bytes; restore the file or import the data again");
        bytes *= extent;
    }
    return bytes;
}

ZarrArray whole_array(ElementType type, std::uint64_t count) {
    return {type, {count}, {std::max<std::uint64_t>(count, 1)}};
}

ZarrArray parse_zarr_array(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(with_nan_as_text(std::string(text)), file);
    const JsonReader document(json, file);
    check_version(document);
    if (const auto compressor = document.find("compressor"))
        compressor->refuse("must be null, because CIEL maps chunks and needs them uncompressed");
    if (const auto filters = document.find("filters"); filters && !filters->items().empty())
        filters->refuse("must be null, because CIEL maps chunks and needs them uncompressed");
    if (document.at("order").text() != "C") document.at("order").refuse("must be \"C\"");
    if (const auto separator = document.find("dimension_separator"); separator && separator->text() != ".")
        separator->refuse("must be \".\"");
    ZarrArray array{parse_type(document.at("dtype")), parse_extents(document.at("shape")),
                    parse_extents(document.at("chunks"))};
    if (array.shape.size() != array.chunks.size())
        document.at("chunks").refuse_damage("must have as many entries as 'shape'");
    if (std::find(array.chunks.begin(), array.chunks.end(), 0U) != array.chunks.end())
        document.at("chunks").refuse_damage("must not contain zero");
    return array;
}

std::string to_text(const ZarrArray& array) {
    nlohmann::json fill = 0;
    const bool is_real = array.type == ElementType::f4 || array.type == ElementType::f8;
    if (is_real) fill = "NaN"; // Zarr libraries then read a missing chunk as NaN, not as zeros
    return to_text(nlohmann::json{{"zarr_format", 2},
                                  {"shape", array.shape},
                                  {"chunks", array.chunks},
                                  {"dtype", row(array.type).name},
                                  {"compressor", nullptr},
                                  {"fill_value", fill},
                                  {"order", "C"},
                                  {"filters", nullptr}});
}

std::string group_text() { return to_text(nlohmann::json{{"zarr_format", 2}}); }

void check_group_text(std::string_view text, const std::filesystem::path& file) {
    const nlohmann::json json = parse_json(text, file);
    check_version(JsonReader(json, file));
}

} // namespace server::store
