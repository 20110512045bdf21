#include "methods/context.hpp"
#include "render/color_map.hpp"

namespace ciel::methods {
namespace {

std::map<std::string, double> table_of(const session::Limits& limits) {
    const auto number = [](auto value) { return static_cast<double>(value); };
    return {{"message_bytes", number(limits.message_bytes)},
            {"json_depth", number(limits.json_depth)},
            {"batch_requests", number(limits.batch_requests)},
            {"connections", number(limits.connections)},
            {"sessions", number(limits.sessions)},
            {"views_per_session", number(limits.views_per_session)},
            {"layers", number(limits.layers)},
            {"values_per_layer", number(limits.values_per_layer)},
            {"undo_steps", number(limits.undo_steps)},
            {"image_side", number(limits.image_side)},
            {"image_pixels", number(limits.image_pixels)},
            {"histogram_bins", number(limits.histogram_bins)},
            {"export_bytes", number(limits.export_bytes)},
            {"field_cache_bytes", number(limits.field_cache_bytes)},
            {"session_memory_bytes", number(limits.session_memory_bytes)},
            {"unacknowledged_frames", number(limits.unacknowledged_frames)},
            {"session_idle_seconds", number(limits.session_idle_seconds)},
            {"request_seconds", number(limits.request_seconds)}};
}

} // namespace

protocol::ServerInfoResult server_info(Context& context, const protocol::ServerInfoParams&) {
    const session::Readiness drawing = context.server.readiness();
    const bool by_signatures = context.server.options().engine == Engine::signatures;
    return {CIEL_VERSION,
            drawing.gl_renderer,
            drawing.backend,
            by_signatures ? "signatures" : "propagation",
            table_of(context.server.limits()),
            render::color_map_names()};
}

} // namespace ciel::methods
