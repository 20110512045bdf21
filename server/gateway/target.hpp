// Parses the request target (RFC 9112, 3.2) into decoded path and query.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace server::gateway {

struct Target {
    std::string path; // decoded once, begins with '/'
    std::map<std::string, std::string> query;
};

// Accepts origin form ("/a?b=c") and absolute form. Returns nothing for a malformed target. Segments "." and ".." are
// not resolved, because paths are table keys, not file names.
[[nodiscard]] std::optional<Target> parse_target(std::string_view target);

// Returns an authority such as "host:80" for a target in absolute form, else an empty text.
[[nodiscard]] std::string_view authority_of(std::string_view target);

// Returns the normal form of a URL prefix: "/ciel" for "ciel" or "/ciel/". An empty prefix stays empty. Throws Error if
// the prefix has characters other than letters, digits and -._~/, or a segment that is empty, "." or "..".
[[nodiscard]] std::string normal_prefix(const std::string& prefix);

// Returns the path below the prefix, or the whole path if a proxy has stripped the prefix. Returns an empty text for
// the prefix itself. The caller must then redirect the client to the prefix with a slash, or relative links break.
[[nodiscard]] std::string_view below_prefix(std::string_view path, std::string_view prefix);

} // namespace server::gateway
