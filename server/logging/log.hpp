// The operator's log: one line per event on stderr, times in UTC. Only this unit defines the format of a line:
//   text  2026-11-23T18:00:00.000Z warning call failed method=surface.export request=3f2a9c01-17 ms=12.5 reason="..."
//   json  {"time":"2026-11-23T18:00:00.000Z","level":"warning","event":"call failed","method":"surface.export",...}
// Never log a query, a cookie, a token or a whole session id.
#pragma once

#include <concepts>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace server::logging {

enum class LogFormat { text, json };
enum class LogLevel { debug, info, warning, error };

// Sets the process's log and the default log of spdlog. `level`: "debug", "info", "warn", "error" or "off".
void start_log(const std::string& level, LogFormat format);

// An empty text means that the value is unknown; the field is then left out.
struct LogField {
    LogField(std::string_view name_, std::string_view text);
    LogField(std::string_view name_, const std::string& text) : LogField(name_, std::string_view(text)) {}
    LogField(std::string_view name_, const char* text) : LogField(name_, std::string_view(text)) {}
    LogField(std::string_view name_, std::floating_point auto number) : LogField(of_number(name_, number)) {}
    LogField(std::string_view name_, std::integral auto number) : name(name_), json(std::to_string(number)) {}

    std::string_view name;
    std::string json; // the value as JSON; empty: unknown

private:
    static LogField of_number(std::string_view name, double number); // formats the number with three decimals
};

// Writes the line if the level is enabled. Thread-safe.
void log_event(LogLevel level, std::string_view event, std::initializer_list<LogField> fields);

// Returns the first eight characters of a session id. Logs must not show more, because a client that knows the id may
// change the scene.
[[nodiscard]] std::string short_id(std::string_view session);

// The id links log lines to the client's answer. It is unique in the process, and very likely among processes.
[[nodiscard]] std::string next_request_id();

} // namespace server::logging
