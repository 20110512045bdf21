#include "logging/log.hpp"

#include "ciel/printable.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <spdlog/pattern_formatter.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <utility>

namespace server::logging {
namespace {

using nlohmann::json;

constexpr std::size_t longest_text = 400; // bytes; a longer value is cut, because it may quote a client's text
constexpr char separator = '\x1f';        // separates the event and its fields of the form NAME=JSON
constexpr spdlog::source_loc with_fields{"log_event", 1, ""}; // marks messages that have fields; a text cannot forge it

std::string json_of(std::string_view text) { return json(text).dump(-1, ' ', false, json::error_handler_t::replace); }

bool is_plain(std::string_view quoted) {
    return quoted.size() > 2 && quoted.find_first_of(" \\=\"", 1) == quoted.size() - 1;
}

// Formats the event and its fields, which follow the time and level in a line.
class Payload : public spdlog::custom_flag_formatter {
public:
    explicit Payload(LogFormat format) : format_(format) {}

    void format(const spdlog::details::log_msg& message, const std::tm&, spdlog::memory_buf_t& out) override {
        std::string_view rest(message.payload.data(), message.payload.size());
        const std::string_view event = message.source.empty() ? std::exchange(rest, {}) : take(rest);
        if (format_ == LogFormat::json)
            append(out, {"\"event\":", json_of(event)});
        else // printable() escapes control characters, which could start a new line
            append(out, {ciel::printable(event)});
        while (!rest.empty()) {
            const std::string_view field = take(rest);
            const auto equals = field.find('=');
            append_field(out, field.substr(0, equals), field.substr(equals + 1));
        }
    }
    [[nodiscard]] std::unique_ptr<custom_flag_formatter> clone() const override {
        return spdlog::details::make_unique<Payload>(format_);
    }

private:
    static std::string_view take(std::string_view& rest) {
        const auto part = rest.substr(0, rest.find(separator));
        rest.remove_prefix(std::min(part.size() + 1, rest.size()));
        return part;
    }
    static void append(spdlog::memory_buf_t& out, std::initializer_list<std::string_view> texts) {
        for (const auto text : texts) out.append(text.data(), text.data() + text.size());
    }
    void append_field(spdlog::memory_buf_t& out, std::string_view name, std::string_view value) const {
        if (format_ == LogFormat::json)
            append(out, {",\"", name, "\":", value});
        else
            append(out, {" ", name, "=", is_plain(value) ? value.substr(1, value.size() - 2) : value});
    }

    LogFormat format_;
};

spdlog::level::level_enum level_of(LogLevel level) {
    switch (level) {
    case LogLevel::debug:
        return spdlog::level::debug;
    case LogLevel::info:
        return spdlog::level::info;
    case LogLevel::warning:
        return spdlog::level::warn;
    case LogLevel::error:
        return spdlog::level::err;
    }
    return spdlog::level::info;
}

} // namespace

void start_log(const std::string& level, LogFormat format) {
    auto logger = std::make_shared<spdlog::logger>("ciel", std::make_shared<spdlog::sinks::stderr_color_sink_mt>());
    auto formatter = std::make_unique<spdlog::pattern_formatter>(spdlog::pattern_time_type::utc);
    formatter->add_flag<Payload>('*', format);
    formatter->set_pattern(format == LogFormat::json ? R"({"time":"%Y-%m-%dT%H:%M:%S.%eZ","level":"%l",%*})"
                                                     : "%Y-%m-%dT%H:%M:%S.%eZ %^%l%$ %*");
    logger->set_formatter(std::move(formatter));
    logger->set_level(spdlog::level::from_str(level));
    logger->flush_on(spdlog::level::info);
    spdlog::set_default_logger(std::move(logger));
}

LogField::LogField(std::string_view name_, std::string_view text) : name(name_) {
    if (text.empty()) return;
    json = json_of(text.size() <= longest_text ? std::string(text) : std::string(text.substr(0, longest_text)) + "...");
}

LogField LogField::of_number(std::string_view name, double number) {
    LogField field(name, std::string_view());
    std::array<char, 48> digits{};
    std::snprintf(digits.data(), digits.size(), "%.3f", std::isfinite(number) ? number : 0);
    field.json = digits.data();
    return field;
}

void log_event(LogLevel level, std::string_view event, std::initializer_list<LogField> fields) {
    if (!spdlog::should_log(level_of(level))) return;
    std::string payload(event);
    for (const LogField& field : fields) {
        if (field.json.empty()) continue;
        payload += separator;
        payload += field.name;
        payload += '=';
        payload += field.json;
    }
    spdlog::log(with_fields, level_of(level), spdlog::string_view_t(payload.data(), payload.size()));
}

std::string short_id(std::string_view session) {
    constexpr std::size_t shown = 8;
    return std::string(session.substr(0, shown));
}

std::string next_request_id() {
    static const std::string process = [] {
        std::array<char, 16> digits{};
        std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(std::random_device()()));
        return std::string(digits.data());
    }();
    static std::atomic<std::uint64_t> last{0};
    return process + "-" + std::to_string(++last);
}

} // namespace server::logging
