#include "limits/limits.hpp"

#include "ciel/printable.hpp"
#include "ciel/types.hpp"
#include "limits/machine_memory.hpp"

#include <algorithm>
#include <array>
#include <charconv>

namespace server::limits {
namespace {

using Unit = LimitRow::Unit;

constexpr std::uint64_t million = 1'000'000, most_bytes = std::uint64_t{1} << 50, most_seconds = 315'360'000;

constexpr auto rows = std::to_array<LimitRow>({
    {"message_bytes", &Limits::message_bytes, Unit::bytes, "size of one JSON-RPC text", most_bytes, 4 << 10},
    {"json_depth", &Limits::json_depth, Unit::count, "nesting depth of JSON", 1000},
    {"batch_requests", &Limits::batch_requests, Unit::count, "requests in one JSON-RPC batch", million},
    {"batch_answer_bytes", &Limits::batch_answer_bytes, Unit::bytes, "size of all answers of one batch", most_bytes},
    {"header_bytes", &Limits::header_bytes, Unit::bytes, "size of an HTTP request's head", 1 << 20, 1 << 10},
    {"connections", &Limits::connections, Unit::count, "open connections", million},
    {"reserved_connections", &Limits::reserved_connections, Unit::count,
     "connections reserved for clients with access, at most half of all", million},
    {"connections_of_address", &Limits::connections_of_address, Unit::count,
     "open connections of one address (IPv6: of one /64); loopback is not counted", million},
    {"refused_connections", &Limits::refused_connections, Unit::count,
     "open connections that are told that the server is full; further ones are closed without an answer", million},
    {"reserved_files", &Limits::reserved_files, Unit::count,
     "file descriptors that connections leave for datasets and child processes", million},
    {"sessions", &Limits::sessions, Unit::count, "sessions kept", million},
    {"views_per_session", &Limits::views_per_session, Unit::count, "views of one session", million},
    {"layers", &Limits::layers, Unit::count, "layers of one scene", 64},
    {"values_per_layer", &Limits::values_per_layer, Unit::count, "iso-values of one layer", 64},
    {"undo_steps", &Limits::undo_steps, Unit::count, "changes that can be undone", million},
    {"scene_bytes", &Limits::scene_bytes, Unit::bytes, "size of one scene as JSON text", most_bytes},
    {"history_bytes", &Limits::history_bytes, Unit::bytes,
     "size of the undo and redo history of a session; above the limit, the oldest scenes are dropped", most_bytes},
    {"image_side", &Limits::image_side, Unit::pixels, "width and height of a picture", 8192},
    {"image_pixels", &Limits::image_pixels, Unit::pixels, "pixels of a picture", 8192 * 8192},
    {"histogram_bins", &Limits::histogram_bins, Unit::count, "bins of a histogram", 4096},
    {"export_bytes", &Limits::export_bytes, Unit::bytes, "size of an exported surface", most_bytes},
    {"uploads", &Limits::uploads, Unit::count, "steps that clients append at a time", 1024},
    {"upload_bytes", &Limits::upload_bytes, Unit::bytes, "size of one appended step", most_bytes},
    {"upload_piece_bytes", &Limits::upload_piece_bytes, Unit::bytes, "size of one piece of an appended step",
     512 << 10},
    {"upload_idle_seconds", &Limits::upload_idle_seconds, Unit::seconds,
     "time without a piece after which an appended step is cancelled", most_seconds},
    {"slow_calls", &Limits::slow_calls, Unit::count, "pictures, exports and other slow calls made at a time", 1024},
    {"slow_calls_waiting", &Limits::slow_calls_waiting, Unit::count, "slow calls that wait, of all connections",
     million},
    {"slow_calls_of_connection", &Limits::slow_calls_of_connection, Unit::count,
     "slow calls that wait, of one connection", million},
    {"late_step_seconds", &Limits::late_step_seconds, Unit::seconds,
     "time that a slow call waits for a step that is read from its source", most_seconds},
    {"import_memory_bytes", &Limits::import_memory_bytes, Unit::memory,
     "memory of one import that the server starts; not counted in memory_bytes", most_bytes, 8 << 20},
    {"import_stalled_seconds", &Limits::import_stalled_seconds, Unit::seconds,
     "time without progress after which an import that the server started is stopped", most_seconds},
    {"field_cache_bytes", &Limits::field_cache_bytes, Unit::memory, "size of the cached fields of one dataset",
     most_bytes},
    {"dataset_memory_bytes", &Limits::dataset_memory_bytes, Unit::memory,
     "size of all datasets in memory; above the limit, unused datasets are released", most_bytes},
    {"dataset_idle_seconds", &Limits::dataset_idle_seconds, Unit::seconds,
     "time without use after which a dataset is released", most_seconds},
    {"session_memory_bytes", &Limits::session_memory_bytes, Unit::memory,
     "size of the query state and the surfaces of one scene", most_bytes},
    {"memory_bytes", &Limits::memory_bytes, Unit::memory, "memory of all clients and datasets", most_bytes, 64 << 20},
    {"unacknowledged_frames", &Limits::unacknowledged_frames, Unit::count,
     "frames of a view that are sent before the client acknowledges the first", 1024},
    {"session_idle_seconds", &Limits::session_idle_seconds, Unit::seconds,
     "time without a connection after which a session is dropped", most_seconds},
    {"keep_alive_seconds", &Limits::keep_alive_seconds, Unit::seconds, "time between two requests of a connection",
     most_seconds},
    {"head_seconds", &Limits::head_seconds, Unit::seconds,
     "time to send the head of a request, and to begin the first request of a connection", most_seconds},
    {"request_seconds", &Limits::request_seconds, Unit::seconds,
     "time to send the body of a request, or to receive a part of its answer", most_seconds},
    {"linger_seconds", &Limits::linger_seconds, Unit::seconds,
     "time that a client has to close a connection after its last answer", most_seconds},
    {"wrong_token_seconds", &Limits::wrong_token_seconds, Unit::seconds, "delay of the answer to a wrong token", 3600},
    {"wrong_tokens_waiting", &Limits::wrong_tokens_waiting, Unit::count,
     "answers to wrong tokens that wait; further wrong tokens are refused at once", million},
    {"waiting_call_bytes", &Limits::waiting_call_bytes, Unit::bytes,
     "size of the waiting requests of a WebSocket; above the limit, the socket is not read", most_bytes},
    {"unsent_bytes", &Limits::unsent_bytes, Unit::bytes,
     "unsent output of a WebSocket, half of it for frames and half for answers; one larger frame may be sent alone",
     most_bytes, 2 << 20},
    {"websocket_idle_seconds", &Limits::websocket_idle_seconds, Unit::seconds,
     "time without a message after which a WebSocket is closed; pings are sent at half of the time", most_seconds},
    {"hang_seconds", &Limits::hang_seconds, Unit::seconds,
     "time without an answer after which a drawing thread counts as hanging, and /readyz fails", most_seconds},
    {"drain_seconds", &Limits::drain_seconds, Unit::seconds, "time from SIGTERM to the exit", most_seconds},
});
static_assert(rows.size() * sizeof(std::uint64_t) == sizeof(Limits), "every limit has a row");

constexpr std::string_view size_letters = "KMGT";

bool is_bytes(const LimitRow& row) { return row.unit == Unit::bytes || row.unit == Unit::memory; }

// Does not check the row's range.
std::uint64_t number_of(const LimitRow& row, std::string_view text) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const std::string_view suffix(end, static_cast<std::size_t>(text.data() + text.size() - end));
    const auto letter = suffix.size() == 1 ? size_letters.find(suffix.front()) : std::string_view::npos;
    const bool is_share = suffix == "%" && row.unit == Unit::memory && value <= 100;
    if (error == std::errc() && suffix.empty()) return value;
    if (error == std::errc() && is_share) return memory_share(static_cast<unsigned>(value));
    if (error == std::errc() && is_bytes(row) && letter != std::string_view::npos) {
        const auto shift = 10 * (letter + 1);
        return value > most_bytes >> shift ? most_bytes + 1 : value << shift;
    }
    const char* expected = " is not a whole number; give a whole number";
    if (is_bytes(row)) expected = " is not a whole number; give a size such as 64M";
    if (row.unit == Unit::memory) expected = " is not a whole number; give a size such as 64M or 25%";
    throw ciel::Error(ciel::printable(text) + expected);
}

} // namespace

std::uint64_t memory_share(unsigned percent) { return machine_memory() / 100 * percent; }

std::span<const LimitRow> limit_rows() { return rows; }

std::string option_of(const LimitRow& row) {
    std::string name = "--limit-";
    name += row.name;
    std::replace(name.begin(), name.end(), '_', '-');
    return name;
}

std::string environment_of(const LimitRow& row) {
    std::string name = "CIEL_LIMIT_";
    name += row.name;
    for (char& c : name)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return name;
}

std::uint64_t parse_limit(const LimitRow& row, std::string_view text) {
    const std::uint64_t value = number_of(row, text);
    if (value < row.least || value > row.most)
        throw ciel::Error(ciel::printable(text) + " is not between " +
                          (row.least > 1 ? limit_text(row, row.least) : "1") + " and " + limit_text(row, row.most));
    return value;
}

std::string limit_text(const LimitRow& row, std::uint64_t value) {
    if (row.unit == Unit::seconds) return std::to_string(value) + " s";
    if (row.unit == Unit::pixels) return std::to_string(value) + " pixels";
    if (!is_bytes(row)) return std::to_string(value);
    std::size_t power = 0;
    // Rounds large sizes down, because a share of the machine's memory need not be a multiple of 1024.
    while (power < size_letters.size() && value >= 1024 && (value % 1024 == 0 || value >= 100 * 1024)) {
        value /= 1024;
        ++power;
    }
    return std::to_string(value) + (power == 0 ? " bytes" : std::string(" ") + size_letters[power - 1] + "iB");
}

} // namespace server::limits
