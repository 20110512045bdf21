// Every limit of a server, in one table. Each row is an option and an environment variable of `ciel serve`, and a
// member of server.info. The tests of a limit are in tests/unit: methods, gateway (sockets) or importing.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace server::limits {

// Returns `percent` of the bytes of machine_memory().
[[nodiscard]] std::uint64_t memory_share(unsigned percent);

// To add a limit, add a member here and a row in limits.cpp.
struct Limits {
    std::uint64_t message_bytes = 1 << 20;
    std::uint64_t json_depth = 32;
    std::uint64_t batch_requests = 64;
    std::uint64_t batch_answer_bytes = 64 << 20;
    std::uint64_t header_bytes = 16 << 10;
    std::uint64_t connections = 128;
    std::uint64_t reserved_connections = 32;
    std::uint64_t connections_of_address = 64;
    std::uint64_t refused_connections = 32;
    std::uint64_t reserved_files = 24;
    std::uint64_t sessions = 64;
    std::uint64_t views_per_session = 8;
    std::uint64_t layers = 64;
    std::uint64_t values_per_layer = 64;
    std::uint64_t undo_steps = 200;
    std::uint64_t scene_bytes = 1 << 20;
    std::uint64_t history_bytes = 8 << 20;
    std::uint64_t image_side = 8192;
    std::uint64_t image_pixels = 33'554'432;
    std::uint64_t histogram_bins = 4096;
    std::uint64_t export_bytes = 256 << 20;
    std::uint64_t uploads = 4;
    std::uint64_t upload_bytes = std::uint64_t{2} << 30;
    std::uint64_t upload_piece_bytes = 512 << 10;
    std::uint64_t upload_idle_seconds = 60;
    std::uint64_t slow_calls = 2;
    std::uint64_t slow_calls_waiting = 64;
    std::uint64_t slow_calls_of_connection = 16;
    std::uint64_t late_step_seconds = 60;
    std::uint64_t import_memory_bytes = memory_share(80);
    // A valid import makes no progress for the longest time while it builds a huge mesh.
    std::uint64_t import_stalled_seconds = 1800;
    std::uint64_t field_cache_bytes = memory_share(20);
    std::uint64_t dataset_memory_bytes = memory_share(40);
    std::uint64_t dataset_idle_seconds = 600;
    std::uint64_t session_memory_bytes = memory_share(10);
    std::uint64_t memory_bytes = memory_share(75);
    std::uint64_t unacknowledged_frames = 2;
    std::uint64_t session_idle_seconds = 3600;
    std::uint64_t keep_alive_seconds = 30;
    std::uint64_t head_seconds = 5;
    std::uint64_t request_seconds = 30;
    std::uint64_t linger_seconds = 2;
    std::uint64_t wrong_token_seconds = 1;
    std::uint64_t wrong_tokens_waiting = 16;
    std::uint64_t waiting_call_bytes = 4 << 20;
    std::uint64_t unsent_bytes = 32 << 20;
    std::uint64_t websocket_idle_seconds = 60;
    std::uint64_t hang_seconds = 60; // longer than any frame takes
    std::uint64_t drain_seconds = 1;
};

struct LimitRow {
    // memory: bytes, or a share of the machine's memory such as "25%"
    enum class Unit { count, bytes, memory, pixels, seconds };
    std::string_view name; // name of the member of Limits, also in server.info
    std::uint64_t Limits::*member;
    Unit unit;
    std::string_view description;
    std::uint64_t most;      // larger values are useless, or refused by openrpc.json
    std::uint64_t least = 1; // a server with less is unusable
};

[[nodiscard]] std::span<const LimitRow> limit_rows();
[[nodiscard]] std::string option_of(const LimitRow& row);      // "--limit-message-bytes"
[[nodiscard]] std::string environment_of(const LimitRow& row); // "CIEL_LIMIT_MESSAGE_BYTES"

// Parses the value of a limit. Bytes may have a suffix K, M, G or T (powers of 1024); memory may be a share such as
// "25%". Throws Error for any other text, and for a value that is not between row.least and row.most.
[[nodiscard]] std::uint64_t parse_limit(const LimitRow& row, std::string_view text);
// Returns the value with its unit, such as "64", "1 MiB" or "30 s".
[[nodiscard]] std::string limit_text(const LimitRow& row, std::uint64_t value);

} // namespace server::limits
