#include "app/limit_options.hpp"

#include "ciel/types.hpp"
#include "limits/limits.hpp"

#include <CLI/CLI.hpp>

namespace server::app {
namespace {

const char* type_name(limits::LimitRow::Unit unit) {
    using Unit = limits::LimitRow::Unit;
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

void add_limits(CLI::App& command, limits::Limits& limits) {
    for (const auto& row : limits::limit_rows()) {
        const auto set = [&limits, &row](const std::string& text) {
            try {
                limits.*row.member = limits::parse_limit(row, text);
            } catch (const ciel::Error& error) {
                throw CLI::ValidationError(limits::option_of(row), error.what());
            }
        };
        command.add_option_function<std::string>(limits::option_of(row), set, std::string(row.description))
            ->default_str(limits::limit_text(row, limits.*row.member))
            ->type_name(type_name(row.unit))
            ->envname(limits::environment_of(row))
            ->group("Limits (sizes also with K, M, G, T; memory also in % of the memory of the machine or cgroup)");
    }
}

} // namespace server::app
