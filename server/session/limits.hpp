// Every limit in one table. server.info tells clients; tests/methods has a test of each, tests/gateway those of
// sockets.
#pragma once

#include <cstddef>
#include <cstdint>

namespace ciel::session {

struct Limits {
    std::size_t message_bytes = 1 << 20; // one JSON-RPC text
    std::size_t json_depth = 32;
    std::size_t batch_requests = 64;
    std::size_t connections = 128;
    std::size_t sessions = 64;
    std::size_t views_per_session = 8;
    std::size_t layers = 64;
    std::size_t values_per_layer = 64;
    std::size_t undo_steps = 200;
    std::uint32_t image_side = 8192;         // pixels
    std::uint64_t image_pixels = 33'554'432; // per picture
    std::size_t histogram_bins = 4096;
    std::size_t export_bytes = 256 << 20;
    unsigned slow_calls = 2;                                 // pictures, exports and the like under way at a time
    std::size_t slow_calls_waiting = 64;                     // of all connections
    std::size_t slow_calls_of_connection = 16;               // of those that wait
    std::size_t field_cache_bytes = std::size_t{4} << 30;    // of one dataset
    std::size_t dataset_memory_bytes = std::size_t{8} << 30; // of all; beyond it those that nobody uses are given back
    unsigned dataset_idle_seconds = 600;                     // without use, until one is given back
    std::size_t session_memory_bytes = std::size_t{2} << 30; // query state and surfaces of one scene
    unsigned unacknowledged_frames = 2;
    unsigned session_idle_seconds = 3600;      // without a connection
    unsigned keep_alive_seconds = 30;          // until the next HTTP request of a connection begins
    unsigned request_seconds = 30;             // to send a whole HTTP request, or to take some of its answer
    std::size_t waiting_text_bytes = 16 << 20; // answers that a WebSocket has not read
    unsigned websocket_idle_seconds = 60;      // without a sign of life; pings go out at half of it
    unsigned drain_seconds = 10;               // from SIGTERM to the end
};

} // namespace ciel::session
