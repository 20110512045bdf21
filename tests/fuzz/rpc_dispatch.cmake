find_package(nlohmann_json REQUIRED)
ciel_fuzz(rpc_dispatch LINKS methods session scene store render wire ciel PACKAGES nlohmann_json::nlohmann_json)
