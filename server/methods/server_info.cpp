#include "methods/context.hpp"
#include "render/color_map.hpp"

namespace ciel::methods {
namespace {

// A row that is added to the limits does not compile until it is named here.
std::map<std::string, double> table_of(const session::Limits& limits) {
    const auto& [message_bytes, json_depth, batch_requests, connections, sessions, views_per_session, layers,
                 values_per_layer, undo_steps, image_side, image_pixels, histogram_bins, export_bytes, slow_calls,
                 slow_calls_waiting, slow_calls_of_connection, field_cache_bytes, dataset_memory_bytes,
                 dataset_idle_seconds, session_memory_bytes, unacknowledged_frames, session_idle_seconds,
                 keep_alive_seconds, request_seconds, waiting_text_bytes, websocket_idle_seconds, drain_seconds] =
        limits;
    const auto number = [](auto value) { return static_cast<double>(value); };
    return {{"message_bytes", number(message_bytes)},
            {"json_depth", number(json_depth)},
            {"batch_requests", number(batch_requests)},
            {"connections", number(connections)},
            {"sessions", number(sessions)},
            {"views_per_session", number(views_per_session)},
            {"layers", number(layers)},
            {"values_per_layer", number(values_per_layer)},
            {"undo_steps", number(undo_steps)},
            {"image_side", number(image_side)},
            {"image_pixels", number(image_pixels)},
            {"histogram_bins", number(histogram_bins)},
            {"export_bytes", number(export_bytes)},
            {"slow_calls", number(slow_calls)},
            {"slow_calls_waiting", number(slow_calls_waiting)},
            {"slow_calls_of_connection", number(slow_calls_of_connection)},
            {"field_cache_bytes", number(field_cache_bytes)},
            {"dataset_memory_bytes", number(dataset_memory_bytes)},
            {"dataset_idle_seconds", number(dataset_idle_seconds)},
            {"session_memory_bytes", number(session_memory_bytes)},
            {"unacknowledged_frames", number(unacknowledged_frames)},
            {"session_idle_seconds", number(session_idle_seconds)},
            {"keep_alive_seconds", number(keep_alive_seconds)},
            {"request_seconds", number(request_seconds)},
            {"waiting_text_bytes", number(waiting_text_bytes)},
            {"websocket_idle_seconds", number(websocket_idle_seconds)},
            {"drain_seconds", number(drain_seconds)}};
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
