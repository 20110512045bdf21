#include "color/color_map.hpp"
#include "methods/call_context.hpp"
#include "protocol/document.hpp"

namespace server::methods {
namespace {

std::map<std::string, double> table_of(const limits::Limits& limits) {
    std::map<std::string, double> table;
    for (const auto& row : limits::limit_rows()) table.emplace(row.name, static_cast<double>(limits.*row.member));
    return table;
}

} // namespace

protocol::ServerInfoResult server_info(CallContext& context, const protocol::ServerInfoParams&) {
    const frames::TestPictureResult drawing = context.server.last_test_picture();
    const bool by_signatures = context.server.options().extraction.algorithm == ciel::Algorithm::signatures;
    const std::string algorithm = by_signatures ? "signatures" : "propagation";
    return {CIEL_VERSION,
            {protocol::major_version, protocol::minor_version},
            drawing.gl_renderer,
            drawing.backend,
            algorithm,
            algorithm, // `engine`, the deprecated name of the member
            table_of(context.server.limits()),
            color::color_map_names(),
            {scene::layer_types.begin(), scene::layer_types.end()},
            {protocol::streams.begin(), protocol::streams.end()}};
}

} // namespace server::methods
