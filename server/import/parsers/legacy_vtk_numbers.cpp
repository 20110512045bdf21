#include "import/parsers/legacy_vtk_numbers.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace server::importer {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

bool is_equal(std::string_view word, std::string_view lower_case) {
    return std::ranges::equal(word, lower_case, {}, lower);
}

const StandIn* stand_in_for(std::string_view word) {
    const bool is_negative = word.starts_with('-');
    if (is_negative || word.starts_with('+')) word.remove_prefix(1);
    const std::string_view name = word.substr(0, word.find('(')); // for example "nan" from "nan(ind)"
    if (is_equal(name, "nan") || is_equal(word, "1.#ind") || is_equal(word, "1.#qnan")) return stand_ins.data();
    if (is_equal(word, "inf") || is_equal(word, "infinity") || is_equal(word, "1.#inf"))
        return &stand_ins[is_negative ? 2 : 1];
    return nullptr;
}

bool is_number(std::string_view word) {
    return word.find_first_not_of("+-.0123456789eE") == std::string_view::npos &&
           word.find_first_of("0123456789") != std::string_view::npos;
}

template <class F>
void for_words(std::string_view line, F&& f) {
    constexpr std::string_view blanks = " \t\r";
    for (std::size_t at = line.find_first_not_of(blanks); at != std::string_view::npos;) {
        const std::size_t end = std::min(line.find_first_of(blanks, at), line.size());
        f(line.substr(at, end - at), at);
        at = line.find_first_not_of(blanks, end);
    }
}

bool holds_values(std::string_view line) {
    bool all = true;
    for_words(line, [&](std::string_view word, std::size_t) {
        all = all && (is_number(word) || stand_in_for(word) != nullptr);
    });
    return all;
}

// Fast test: all words for NaN and infinity contain the letter n, and no number contains it.
bool may_hold_some(std::string_view line) { return line.find_first_of("nN") != std::string_view::npos; }

void append_line(std::string_view line, std::string& out) {
    if (!may_hold_some(line) || !holds_values(line)) {
        out += line;
        return;
    }
    std::size_t written = 0;
    for_words(line, [&](std::string_view word, std::size_t at) {
        const StandIn* stand_in = stand_in_for(word);
        if (stand_in == nullptr) return;
        out += line.substr(written, at - written);
        out += stand_in->text;
        written = at + word.size();
    });
    out += line.substr(written);
}

} // namespace

bool holds_no_numbers(std::istream& file) {
    for (std::string line; std::getline(file, line);)
        if (may_hold_some(line) && holds_values(line)) return true;
    return false;
}

std::string with_stand_ins(std::istream& file) {
    std::string out;
    for (std::string line; std::getline(file, line);) {
        append_line(line, out);
        if (!file.eof()) out += '\n';
    }
    return out;
}

} // namespace server::importer
