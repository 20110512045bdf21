#include "gateway/target.hpp"

#include "ciel/types.hpp"

#include <algorithm>

namespace server::gateway {
namespace {

int hex_digit(char c) {
    if (c >= '0' && c <= '9') return c - '0';
    if (c >= 'a' && c <= 'f') return c - 'a' + 10;
    if (c >= 'A' && c <= 'F') return c - 'A' + 10;
    return -1;
}

bool is_control(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }

std::optional<std::string> percent_decoded(std::string_view text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        char c = text[i];
        if (c == '%') {
            if (i + 2 >= text.size()) return std::nullopt;
            const int high = hex_digit(text[i + 1]), low = hex_digit(text[i + 2]);
            if (high < 0 || low < 0) return std::nullopt;
            c = static_cast<char>(high * 16 + low);
            i += 2;
        }
        if (is_control(c)) return std::nullopt;
        out += c;
    }
    return out;
}

bool parse_query(std::string_view text, std::map<std::string, std::string>& query) {
    while (!text.empty()) {
        const auto pair = text.substr(0, text.find('&'));
        text.remove_prefix(std::min(pair.size() + 1, text.size()));
        const auto equals = std::min(pair.find('='), pair.size());
        const auto name = percent_decoded(pair.substr(0, equals));
        const auto value = percent_decoded(pair.substr(std::min(equals + 1, pair.size())));
        if (!name || !value) return false;
        query.emplace(*name, *value);
    }
    return true;
}

bool is_absolute(std::string_view target) { return target.starts_with("http://") || target.starts_with("https://"); }

} // namespace

std::string_view authority_of(std::string_view target) {
    if (!is_absolute(target)) return {};
    target.remove_prefix(target.find("//") + 2);
    return target.substr(0, target.find_first_of("/?"));
}

std::optional<Target> parse_target(std::string_view target) {
    if (is_absolute(target)) {
        const auto authority = authority_of(target);
        if (authority.empty()) return std::nullopt;
        target.remove_prefix(static_cast<std::size_t>(authority.data() + authority.size() - target.data()));
    }
    if (!target.starts_with('/')) return std::nullopt;
    const auto end_of_path = std::min(target.find('?'), target.size());
    auto path = percent_decoded(target.substr(0, end_of_path));
    if (!path) return std::nullopt;
    Target result{std::move(*path), {}};
    if (!parse_query(target.substr(std::min(end_of_path + 1, target.size())), result.query)) return std::nullopt;
    return result;
}

std::string normal_prefix(const std::string& prefix) {
    const auto allowed = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("-._~/").find(c) != std::string_view::npos;
    };
    if (!std::all_of(prefix.begin(), prefix.end(), allowed))
        throw ciel::Error("the prefix \"" + prefix + "\" may contain only letters, digits and -._~/; change --prefix");
    std::string result = prefix;
    while (result.ends_with('/')) result.pop_back();
    if (!result.empty() && result.front() != '/') result.insert(result.begin(), '/');
    for (const std::string_view removed : {"//", "/./", "/../"}) // browsers and proxies remove them
        if ((result + '/').find(removed) != std::string::npos)
            throw ciel::Error("the prefix \"" + prefix +
                              "\" must not have an empty part or the parts . and ..; change --prefix");
    return result;
}

std::string_view below_prefix(std::string_view path, std::string_view prefix) {
    if (prefix.empty() || !path.starts_with(prefix)) return path;
    const auto rest = path.substr(prefix.size());
    return rest.empty() || rest.front() == '/' ? rest : path;
}

} // namespace server::gateway
