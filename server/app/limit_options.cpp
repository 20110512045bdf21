#include "app/limit_options.hpp"

#include "ciel/types.hpp"
#include "session/limits.hpp"

#include <CLI/CLI.hpp>

namespace ciel::app {
namespace {

const char* type_name(session::LimitRow::Unit unit) {
    using Unit = session::LimitRow::Unit;
    switch (unit) {
    case Unit::bytes:
        return "BYTES";
    case Unit::memory:
        return "BYTES|N%";
    case Unit::pixels:
        return "PIXELS";
    case Unit::seconds:
        return "SECONDS";
    case Unit::count:
        break;
    }
    return "COUNT";
}

} // namespace

void add_limits(CLI::App& command, session::Limits& limits) {
    for (const auto& row : session::limit_rows()) {
        const auto set = [&limits, &row](const std::string& text) {
            try {
                limits.*row.member = session::parse_limit(row, text);
            } catch (const Error& error) {
                throw CLI::ValidationError(session::option_of(row), error.what());
            }
        };
        command.add_option_function<std::string>(session::option_of(row), set, std::string(row.description))
            ->default_str(session::limit_text(row, limits.*row.member))
            ->type_name(type_name(row.unit))
            ->envname(session::environment_of(row))
            ->group("Limits (sizes also with K, M, G, T; memory also as a share of the machine's or the cgroup's)");
    }
}

} // namespace ciel::app
