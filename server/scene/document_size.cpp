#include "scene/document_size.hpp"

#include <nlohmann/json.hpp>

namespace server::scene {
namespace {

using nlohmann::json;

constexpr std::size_t allocation = 16;                      // bytes of header and rounding per heap allocation
constexpr std::size_t tree_node = 32 + sizeof(std::string); // node of a std::map: color, three pointers, key
constexpr std::size_t short_string = 15;                    // longest text that is stored inside the std::string

std::size_t characters(const std::string& text) {
    return text.capacity() > short_string ? text.capacity() + 1 + allocation : 0;
}

} // namespace

std::size_t text_bytes(const json& document) {
    return document.dump(-1, ' ', false, json::error_handler_t::replace).size();
}

std::size_t heap_bytes(const json& document) {
    std::size_t bytes = 0;
    if (const auto* text = document.get_ptr<const std::string*>()) {
        bytes += sizeof(std::string) + allocation + characters(*text);
    } else if (const auto* list = document.get_ptr<const json::array_t*>()) {
        bytes += sizeof(json::array_t) + 2 * allocation + (list->capacity() - list->size()) * sizeof(json);
        for (const json& item : *list) bytes += sizeof item + heap_bytes(item);
    } else if (const auto* object = document.get_ptr<const json::object_t*>()) {
        bytes += sizeof(json::object_t) + allocation;
        for (const auto& [name, member] : *object)
            bytes += tree_node + allocation + characters(name) + sizeof member + heap_bytes(member);
    }
    return bytes;
}

} // namespace server::scene
