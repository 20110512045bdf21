#include "import/parsers/openfoam/macros.hpp"

#include "ciel/types.hpp"
#include "import/parsers/openfoam/reader.hpp"

#include <algorithm>
#include <cctype>
#include <map>

namespace server::importer {

namespace {

constexpr int deepest = 16;
constexpr std::size_t longest_value = 4096;      // bytes; a macro with a longer value expands to nothing
constexpr std::size_t longest_text = 256U << 20; // bytes of the expanded text

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

class Expander {
public:
    Expander(const std::string& file, const LoadIncluded& load) : file_(file), load_(load) {}

    std::string run(std::string_view text) {
        add(text, 0);
        return std::move(out_);
    }

private:
    [[noreturn]] void fail(const std::string& what) const { throw ciel::Error(file_ + ": " + what); }

    void add(std::string_view text, int depth) {
        if (depth > deepest) fail("its #include directives are nested too deep");
        for (std::size_t at = 0; at < text.size();) {
            if (out_.size() > longest_text)
                fail("its macros expand to more than " + std::to_string(longest_text >> 20) +
                     " MiB; does one contain itself?");
            if (text.substr(at).starts_with("//")) {
                at = std::min(text.find('\n', at), text.size());
            } else if (text.substr(at).starts_with("/*")) {
                const std::size_t end = text.find("*/", at + 2);
                at = end == std::string_view::npos ? text.size() : end + 2;
            } else if (text[at] == '"') {
                const std::size_t end = text.find('"', at + 1);
                const std::size_t next = end == std::string_view::npos ? text.size() : end + 1;
                out_.append(text.substr(at, next - at));
                at = next;
            } else if (text[at] == '#') {
                at = directive(text, at, depth);
            } else if (text[at] == '$') {
                at = substitute(text, at);
            } else {
                put(text[at++]);
            }
        }
    }

    // If c ends a top-level entry "NAME value;", stores the entry for $NAME.
    void put(char c) {
        out_ += c;
        if (c == '{') ++braces_;
        if (c == '}') --braces_;
        if (braces_ == 0 && (c == ';' || c == '}')) {
            if (c == ';') remember(std::string_view(out_).substr(entry_));
            entry_ = out_.size();
        }
    }

    void remember(std::string_view entry) {
        const auto begin = std::find_if(entry.begin(), entry.end(), is_name);
        if (begin == entry.end()) return;
        const auto end = std::find_if_not(begin, entry.end(), is_name); // never entry.end(): the entry ends with ';'
        std::string name(begin, end), value(end, entry.end() - 1);      // without the semicolon
        values_[std::move(name)] = value.size() <= longest_value ? std::move(value) : std::string();
    }

    std::size_t directive(std::string_view text, std::size_t at, int depth) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string_view line = text.substr(at, end - at);
        const auto name_end = std::find_if_not(line.begin() + 1, line.end(), is_name);
        const std::string_view what(line.begin() + 1, name_end);
        if (what == "includeEtc" || what == "inputMode" || what == "remove") return end;
        if (!what.starts_with("include")) fail("#" + std::string(what) + " cannot be evaluated outside OpenFOAM");
        const std::size_t open = line.find('"');
        const std::size_t close = open == std::string_view::npos ? open : line.find('"', open + 1);
        if (close == std::string_view::npos) fail("#" + std::string(what) + " names no file");
        const std::string included(line.substr(open + 1, close - open - 1));
        if (const std::optional<std::string> loaded = load_(included))
            add(*loaded, depth + 1);
        else if (what == "include")
            fail("includes " + included + ", which does not exist");
        return at + close + 1;
    }

    std::size_t substitute(std::string_view text, std::size_t at) {
        std::size_t begin = at + 1;
        const bool in_braces = begin < text.size() && text[begin] == '{';
        while (begin < text.size() && (text[begin] == '{' || text[begin] == ':' || text[begin] == '.')) ++begin;
        std::size_t end = begin;
        while (end < text.size() && is_name(text[end])) ++end;
        const std::string name(text.substr(begin, end - begin));
        const auto known = values_.find(name);
        if (known == values_.end()) fail("$" + name + " is used before it is defined");
        out_ += known->second;
        return in_braces && end < text.size() && text[end] == '}' ? end + 1 : end;
    }

    const std::string& file_;
    const LoadIncluded& load_;
    std::string out_;
    std::size_t entry_ = 0;
    int braces_ = 0;
    std::map<std::string, std::string> values_;
};

} // namespace

std::string expand_foam_macros(std::string text, const std::string& file, const LoadIncluded& load) {
    if (text.find_first_of("#$") == std::string::npos || FoamReader(text, file).format().is_binary) return text;
    return Expander(file, load).run(text);
}

} // namespace server::importer
