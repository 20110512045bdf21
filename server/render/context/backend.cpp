#include "render/context/backend.hpp"

#include "ciel/types.hpp"

namespace server::render {
namespace {

struct BackendName {
    Backend backend;
    const char* name;
};
constexpr BackendName backend_names[] = {
    {Backend::automatic, "auto"},
    {Backend::egl_device, "egl-device"},
    {Backend::egl_surfaceless, "egl-surfaceless"},
    {Backend::osmesa, "osmesa"},
};

} // namespace

const char* name_of(Backend backend) {
    for (const BackendName& named : backend_names)
        if (named.backend == backend) return named.name;
    return "unknown";
}

Backend backend_named(const std::string& name) {
    std::string known;
    for (const BackendName& named : backend_names) {
        if (name == named.name) return named.backend;
        known += (known.empty() ? "" : ", ") + std::string(named.name);
    }
    throw ciel::Error("there is no GL back end '" + name + "'; use one of these: " + known);
}

} // namespace server::render
