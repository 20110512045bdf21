#include "methods/context.hpp"
#include "render/color_map.hpp"

namespace ciel::methods {
namespace {

std::map<std::string, double> table_of(const session::Limits& limits) {
    std::map<std::string, double> table;
    for (const auto& row : session::limit_rows()) table.emplace(row.name, static_cast<double>(limits.*row.member));
    return table;
}

} // namespace

protocol::ServerInfoResult server_info(Context& context, const protocol::ServerInfoParams&) {
    const session::Readiness drawing = context.server.last_readiness();
    const bool by_signatures = context.server.options().extraction.engine == Engine::signatures;
    return {CIEL_VERSION,
            drawing.gl_renderer,
            drawing.backend,
            by_signatures ? "signatures" : "propagation",
            table_of(context.server.limits()),
            render::color_map_names()};
}

} // namespace ciel::methods
