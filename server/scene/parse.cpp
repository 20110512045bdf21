#include "ciel/printable.hpp"
#include "protocol/read_scene.hpp"
#include "scene/rules.hpp"
#include "scene/schema.hpp"

namespace ciel::scene {
namespace {

using nlohmann::json;

// Refuses a scene with the member /legend. The error names its replacement, annotations.legend.
void refuse_old_legend(const json& document) {
    if (document.is_object() && document.contains("legend"))
        throw Invalid(
            "/legend",
            "/legend is not a member of a scene; use annotations.legend: {\"annotations\": {\"legend\": true}}");
}

} // namespace

Scene parse(const json& document) {
    static const json& schema = contract().at("components").at("schemas").at("Scene");
    refuse_old_legend(document);
    if (const auto violation = check_schema(schema, document))
        throw Invalid(violation->path,
                      (violation->path.empty() ? "the scene" : printable(violation->path)) + " " + violation->reason);
    Scene scene;
    read(document, scene);
    apply_rules(scene);
    return scene;
}

} // namespace ciel::scene
