find_package(nlohmann_json REQUIRED)
ciel_fuzz(scene_parse LINKS scene PACKAGES nlohmann_json::nlohmann_json)
