#include "sessions/accept_scene.hpp"

#include "limits/errors.hpp"
#include "scene/document_size.hpp"
#include "sessions/open_dataset.hpp"

namespace server::sessions {
namespace {

void check_size(const nlohmann::json& document, const limits::Limits& limits) {
    const std::size_t bytes = scene::text_bytes(document);
    if (bytes > limits.scene_bytes)
        throw limits::LimitReached("the scene would have " + std::to_string(bytes) +
                                   " bytes; a scene may have at most " + std::to_string(limits.scene_bytes) +
                                   ". Remove layers, values or patches from the scene");
}

void check_limits(const scene::Scene& scene, const limits::Limits& limits) {
    if (scene.layers.size() > limits.layers)
        throw limits::LimitReached("a scene may have at most " + std::to_string(limits.layers) +
                                   " layers; remove a layer");
    for (const scene::Layer& layer : scene.layers)
        if (const auto* iso = std::get_if<scene::IsoLayer>(&layer.kind))
            if (iso->values.size() > limits.values_per_layer)
                throw limits::LimitReached("layer " + layer.id + " may have at most " +
                                           std::to_string(limits.values_per_layer) + " values; remove values");
}

} // namespace

std::shared_ptr<const SceneVersion> accept_scene(const SessionServices& services, nlohmann::json document,
                                                 std::uint64_t revision, std::string request) {
    // Removes nulls, which mean the same as absent members; a merge patch (RFC 7396) cannot set a member to null.
    document = scene::merge_patch(nlohmann::json::object(), document);
    check_size(document, services.limits);
    scene::Scene scene = scene::parse(document);
    check_limits(scene, services.limits);
    auto loaded = open_dataset(services.catalog, scene.dataset);
    const std::size_t bytes = 2 * scene::heap_bytes(document); // the parsed scene has about the same size
    return std::make_shared<const SceneVersion>(SceneVersion{
        revision, std::make_shared<const nlohmann::json>(std::move(document)),
        scene::CheckedScene(std::move(scene), std::move(loaded)), bytes, Clock::now(), std::move(request)});
}

} // namespace server::sessions
