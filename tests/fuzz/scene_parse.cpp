// Fuzzes diff and merge_patch with a document and a patch, two lines of JSON.
#include "scene/scene.hpp"

#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

using nlohmann::json;
using namespace server::scene;

namespace {

bool is_scene(const json& document) {
    try {
        (void)parse(document);
        return true;
    } catch (const Invalid&) {
        return false;
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto line = text.substr(0, text.find('\n'));
    const auto rest = text.substr(std::min(line.size() + 1, text.size()));
    const json document = json::parse(line.begin(), line.end(), nullptr, false);
    const json patch = json::parse(rest.begin(), rest.end(), nullptr, false);
    if (document.is_discarded()) return 0;
    (void)is_scene(document);
    if (patch.is_discarded()) return 0;
    const json from = merge_patch(json::object(), document); // removes nulls
    const json to = merge_patch(from, patch);
    (void)is_scene(to);
    if (to.is_object() && merge_patch(from, diff(from, to)) != to) std::abort();
    return 0;
}
