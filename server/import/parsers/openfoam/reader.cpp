#include "import/parsers/openfoam/reader.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace server::importer {

namespace {

bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

template <typename Stored, typename Value>
void append_raw(std::string_view raw, std::vector<Value>& values) {
    values.reserve(values.size() + raw.size() / sizeof(Stored));
    for (std::size_t at = 0; at < raw.size(); at += sizeof(Stored)) {
        Stored value;
        std::memcpy(&value, raw.data() + at, sizeof(Stored));
        values.push_back(static_cast<Value>(value));
    }
}

} // namespace

int foam_components(std::string_view type) {
    constexpr std::pair<std::string_view, int> types[] = {
        {"scalar", 1}, {"vector", 3}, {"sphericalTensor", 1}, {"symmTensor", 6}, {"tensor", 9}};
    for (const auto& [name, components] : types)
        if (type == name) return components;
    return 0;
}

FoamReader::FoamReader(std::string_view bytes, std::string name) : bytes_(bytes), file_(std::move(name)) {
    skip_space();
    if (rest().starts_with("FoamFile")) read_header();
}

void FoamReader::fail(const std::string& what) const {
    throw ciel::Error(file_ + ": " + what + " at byte " + std::to_string(at_));
}

void FoamReader::read_header() {
    static_cast<void>(word());
    expect('{');
    while (!accept('}')) {
        const std::string_view key = word();
        bool is_quoted = false;
        if (key == "format") {
            format_.is_binary = word() == "binary";
        } else if (key == "class") {
            format_.class_name = name(is_quoted);
        } else if (key == "arch") {
            set_architecture(name(is_quoted));
        }
        skip_entry();
    }
}

// `text`: the entry `arch` of a file header, such as "LSB;label=32;scalar=64".
void FoamReader::set_architecture(std::string_view text) {
    if (text.find("MSB") != std::string_view::npos)
        fail("is written for a big-endian machine (convert the file with foamFormatConvert)");
    if (text.find("label=64") != std::string_view::npos) format_.label_bytes = 8;
    if (text.find("scalar=32") != std::string_view::npos) format_.scalar_bytes = 4;
}

void FoamReader::skip_space() {
    while (at_ < bytes_.size()) {
        if (is_space(bytes_[at_])) {
            ++at_;
        } else if (rest().starts_with("//")) {
            at_ = std::min(bytes_.find('\n', at_), bytes_.size());
        } else if (rest().starts_with("/*")) {
            const std::size_t end = bytes_.find("*/", at_ + 2);
            at_ = end == std::string_view::npos ? bytes_.size() : end + 2;
        } else {
            return;
        }
    }
}

bool FoamReader::at_end() {
    skip_space();
    return at_ == bytes_.size();
}

char FoamReader::peek() { return at_end() ? '\0' : bytes_[at_]; }

bool FoamReader::accept(char c) {
    if (at_end() || bytes_[at_] != c) return false;
    ++at_;
    return true;
}

void FoamReader::expect(char c) {
    if (accept(c)) return;
    fail(at_ == bytes_.size() ? "ends too early" : std::string("has no '") + c + "' where this character is needed");
}

std::string_view FoamReader::word() {
    skip_space();
    const std::size_t begin = at_;
    int open = 0;
    for (; at_ < bytes_.size(); ++at_) {
        const char c = bytes_[at_];
        if (is_space(c) || c == ';' || c == '{' || c == '}' || c == '"' || c == '[' || c == ']') break;
        if (c == '(' && at_ > begin) ++open; // as in div(phi,U)
        if (c == '(' && at_ == begin) break;
        if (c == ')' && --open < 0) break;
    }
    if (at_ == begin) fail(at_ == bytes_.size() ? "ends too early" : "has no word where a word is needed");
    return bytes_.substr(begin, at_ - begin);
}

std::string_view FoamReader::name(bool& is_quoted) {
    is_quoted = peek() == '"';
    if (!is_quoted) return word();
    const std::size_t begin = at_ + 1;
    skip_quoted();
    return bytes_.substr(begin, at_ - begin - 1);
}

void FoamReader::skip_quoted() {
    for (++at_; at_ < bytes_.size() && bytes_[at_] != '"'; ++at_)
        if (bytes_[at_] == '\\') ++at_;
    if (at_ >= bytes_.size()) {
        at_ = bytes_.size();
        fail("ends too early");
    }
    ++at_;
}

double FoamReader::number() {
    skip_space();
    const char* const begin = bytes_.data() + at_;
    const char* const end = bytes_.data() + bytes_.size();
    const char* const digits = begin != end && *begin == '+' ? begin + 1 : begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(digits, end, value);
    if (error == std::errc::invalid_argument)
        fail(begin == end ? "ends too early" : "has no number where a number is needed");
    // from_chars stores nothing for a number out of range. strtod returns infinity, zero or a denormal.
    if (error == std::errc::result_out_of_range) value = std::strtod(std::string(digits, stop).c_str(), nullptr);
    at_ = static_cast<std::size_t>(stop - bytes_.data());
    return value;
}

std::int64_t FoamReader::label() {
    skip_space();
    std::int64_t value = 0;
    const auto [stop, error] = std::from_chars(bytes_.data() + at_, bytes_.data() + bytes_.size(), value);
    if (error != std::errc{})
        fail(at_ == bytes_.size() ? "ends too early" : "has no whole number where a whole number is needed");
    at_ = static_cast<std::size_t>(stop - bytes_.data());
    return value;
}

std::size_t FoamReader::items(std::size_t most) {
    const std::int64_t items = label();
    if (items < 0 || static_cast<std::uint64_t>(items) > most)
        fail("has a list of " + std::to_string(items) + " items; the number must be between 0 and " +
             std::to_string(most) + ",");
    return static_cast<std::size_t>(items);
}

std::string_view FoamReader::raw(std::size_t bytes) {
    expect('(');
    if (bytes > bytes_.size() - at_) {
        at_ = bytes_.size();
        fail("ends too early");
    }
    const std::string_view data = bytes_.substr(at_, bytes);
    at_ += bytes;
    expect(')');
    return data;
}

void FoamReader::read_item(int components, std::vector<double>& values) {
    if (components == 1) {
        const bool in_brackets = accept('('); // spherical tensors have one component in brackets
        values.push_back(number());
        if (in_brackets) expect(')');
        return;
    }
    expect('(');
    for (int i = 0; i < components; ++i) values.push_back(number());
    expect(')');
}

std::vector<double> FoamReader::numbers(int components, std::size_t most) {
    std::vector<double> values;
    const auto width = static_cast<std::size_t>(components);
    if (peek() == 'L') static_cast<void>(word());
    if (accept('(')) {
        while (!accept(')')) read_item(components, values);
        return values;
    }
    const std::size_t size = items(most);
    if (accept('{')) {
        read_item(components, values);
        expect('}');
        values.reserve(size * width);
        for (std::size_t i = width; i < size * width; ++i) values.push_back(values[i - width]);
        values.resize(size * width);
    } else if (size == 0) {
        if (accept('(')) expect(')');
    } else if (format_.is_binary) {
        const std::string_view data = raw(size * width * static_cast<std::size_t>(format_.scalar_bytes));
        format_.scalar_bytes == 4 ? append_raw<float>(data, values) : append_raw<double>(data, values);
    } else {
        values.reserve(std::min(size * width, bytes_left()));
        expect('(');
        for (std::size_t i = 0; i < size; ++i) read_item(components, values);
        expect(')');
    }
    return values;
}

std::vector<std::int64_t> FoamReader::labels(std::size_t most) {
    std::vector<std::int64_t> values;
    if (peek() == 'L') static_cast<void>(word());
    if (accept('(')) {
        while (!accept(')')) values.push_back(label());
        return values;
    }
    const std::size_t size = items(most);
    if (accept('{')) {
        values.assign(size, label());
        expect('}');
    } else if (size == 0) {
        if (accept('(')) expect(')');
    } else if (format_.is_binary) {
        const std::string_view data = raw(size * static_cast<std::size_t>(format_.label_bytes));
        format_.label_bytes == 4 ? append_raw<std::int32_t>(data, values) : append_raw<std::int64_t>(data, values);
    } else {
        values.reserve(std::min(size, bytes_left()));
        expect('(');
        for (std::size_t i = 0; i < size; ++i) values.push_back(label());
        expect(')');
    }
    return values;
}

// Skips a binary list by its size, because its raw bytes can look like brackets or semicolons.
void FoamReader::skip_list(std::string_view type) {
    if (!format_.is_binary) return;
    std::size_t item = static_cast<std::size_t>(foam_components(type)) * static_cast<std::size_t>(format_.scalar_bytes);
    if (type == "label") item = static_cast<std::size_t>(format_.label_bytes);
    if (type == "bool") item = 1;
    const char next = peek();
    if (item == 0 || next < '0' || next > '9') return;
    const std::size_t size = items(bytes_left());
    if (size > 0 && peek() == '(') static_cast<void>(raw(size * item));
}

void FoamReader::skip_entry() {
    const bool is_dictionary = peek() == '{';
    int depth = 0;
    while (true) {
        const char c = peek();
        if (c == '\0' && at_ == bytes_.size()) fail("ends too early");
        if (c == '"') {
            skip_quoted();
        } else if (c == '{' || c == '(' || c == '[') {
            ++depth;
            ++at_;
        } else if (c == '}' || c == ')' || c == ']') {
            if (depth == 0) return; // the enclosing dictionary ends; the semicolon is missing
            ++at_;
            if (--depth == 0 && is_dictionary) return static_cast<void>(accept(';'));
        } else if (c == ';') {
            ++at_;
            if (depth == 0) return;
        } else if (rest().starts_with("List<")) {
            const std::string_view list = word();
            skip_list(list.substr(5, list.find('>') - std::min<std::size_t>(5, list.find('>'))));
        } else {
            ++at_;
        }
    }
}

} // namespace server::importer
