find_package(nlohmann_json REQUIRED)
ciel_fuzz(rpc_dispatch LINKS methods PACKAGES nlohmann_json::nlohmann_json)
