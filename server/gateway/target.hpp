// The request target (RFC 9112, 3.2) taken apart: decoded path and query.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace ciel::gateway {

struct Target {
    std::string path; // decoded once, begins with '/'
    std::map<std::string, std::string> query;
};

// Origin form ("/a?b=c") or absolute form ("http://host/a?b=c"). Nothing when it is malformed: no leading slash, no
// host, a bad escape, a control character. Dots are not resolved: paths are keys of tables, never names of files.
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

// "host:80" of an absolute form; empty of an origin form.
[[nodiscard]] std::string_view authority_of(std::string_view target);

// "/ciel" from "ciel", "/ciel/"; empty stays empty. Throws Error when it holds anything but letters, digits and -._~/,
// or a part that is empty, "." or "..".
[[nodiscard]] std::string normal_prefix(const std::string& prefix);

// The path below the prefix, whether the proxy in front has kept the prefix or taken it off. Empty when the path is the
// prefix itself: the client must be sent to "prefix/", or its relative links would miss.
[[nodiscard]] std::string_view below_prefix(std::string_view path, std::string_view prefix);

} // namespace ciel::gateway
