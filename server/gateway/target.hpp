// Parses the request target (RFC 9112, 3.2) into decoded path and query.
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

// Parses a request target in origin form ("/a?b=c") or absolute form ("http://host/a?b=c"). Returns nothing if it is
// malformed: no leading slash, no host, a bad escape, a control character. Dots are not resolved: paths are table keys,
// not file names.
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

// Returns the authority of a request target: "host:80" of absolute form; empty for origin form.
[[nodiscard]] std::string_view authority_of(std::string_view target);

// Returns the normal form of a URL prefix: "/ciel" for "ciel" or "/ciel/"; empty stays empty. Throws Error when the
// prefix has characters other than letters, digits and -._~/, or a part that is empty, "." or "..".
[[nodiscard]] std::string normal_prefix(const std::string& prefix);

// Returns the part of a path below the prefix, or the whole path if a proxy has stripped the prefix. Returns an empty
// text if the path is the prefix itself: the client must then be redirected to "prefix/", or its relative links break.
[[nodiscard]] std::string_view below_prefix(std::string_view path, std::string_view prefix);

} // namespace ciel::gateway
