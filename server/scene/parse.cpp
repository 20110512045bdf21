#include "ciel/printable.hpp"
#include "protocol/read_scene.hpp"
#include "scene/rules.hpp"
#include "scene/schema.hpp"

namespace server::scene {

Scene parse(const nlohmann::json& document) {
    static const nlohmann::json& schema = contract().at("components").at("schemas").at("Scene");
    refuse_old_legend(document);
    if (const auto violation = check_schema(schema, document))
        throw Invalid(violation->path, (violation->path.empty() ? "the scene" : ciel::printable(violation->path)) +
                                           " " + violation->reason);
    Scene scene;
    read(document, scene);
    apply_rules(scene);
    return scene;
}

} // namespace server::scene
