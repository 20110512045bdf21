#include "import/parsers/legacy_vtk_counts.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <optional>
#include <string_view>

namespace server::importer {

namespace {

constexpr std::size_t longest_word = 256; // number of bytes kept of a word; keywords, types and counts are shorter
constexpr double bits_per_byte = 8;

struct ValueType {
    std::string_view name;
    unsigned bytes; // size of one value in a binary file; 0: the size varies, or is less than a byte
};
constexpr ValueType value_types[] = {
    {"bit", 0},         {"char", 1},           {"signed_char", 1},  {"unsigned_char", 1},
    {"short", 2},       {"unsigned_short", 2}, {"int", 4},          {"unsigned_int", 4},
    {"long", 8},        {"unsigned_long", 8},  {"vtktypeint64", 8}, {"vtktypeuint64", 8},
    {"vtkidtype", 4},   {"float", 4},          {"double", 8},       {"string", 0},
    {"utf8_string", 0}, {"variant", 0},
};

const ValueType* find_type(std::string_view word) {
    const auto* found = std::find_if(std::begin(value_types), std::end(value_types),
                                     [&](const ValueType& type) { return type.name == word; });
    return found == std::end(value_types) ? nullptr : found;
}

// Returns infinity if the number does not fit in 64 bits, and nullopt if the word is not a whole number.
std::optional<double> to_count(std::string_view word) {
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size()) return std::nullopt;
    if (error == std::errc::result_out_of_range) return std::numeric_limits<double>::infinity();
    if (error != std::errc{}) return std::nullopt;
    return static_cast<double>(value);
}

// Converts the words to lower case, because VTK ignores case.
class Words {
public:
    explicit Words(std::istream& file) : buffer_(*file.rdbuf()) {}

    bool next(std::string& word) {
        word.clear();
        int c = buffer_.sbumpc();
        while (is_space(c)) c = buffer_.sbumpc();
        for (; c != end && !is_space(c); c = buffer_.sbumpc())
            if (word.size() < longest_word) word += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        after_ = c;
        return !word.empty();
    }

    void skip_line() {
        do after_ = buffer_.sbumpc();
        while (after_ != '\n' && after_ != end);
    }

    void skip_values(std::uint64_t bytes) {
        if (after_ != '\n' && after_ != end) skip_line();
        buffer_.pubseekoff(static_cast<std::streamoff>(bytes), std::ios::cur, std::ios::in);
    }

private:
    static constexpr int end = std::char_traits<char>::eof();
    static bool is_space(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

    std::streambuf& buffer_;
    int after_ = end; // the character that ended the last word
};

class Check {
public:
    Check(std::uint64_t file_size, const std::string& name) : size_(static_cast<double>(file_size)), name_(name) {}

    // Checks the counts that end with this word. Returns the bytes of the binary values after it; 0 if none or unknown.
    std::uint64_t take(std::string&& word) {
        std::rotate(words_.begin(), words_.begin() + 1, words_.end());
        words_.back() = std::move(word);
        return declares_cells() || declares_items() || declares_components() ? 0 : declared_values();
    }

private:
    static bool is_one_of(std::string_view word, std::initializer_list<std::string_view> keywords) {
        return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
    }

    // `per_byte`: most items in one byte of the file. The error quotes the declaration: the last `length` words.
    void require(double count, double per_byte, std::size_t length) const {
        if (count >= 0 && count <= size_ * per_byte) return;
        std::string declaration;
        for (std::size_t i = words_.size() - length; i < words_.size(); ++i)
            declaration.append(declaration.empty() ? "" : " ").append(words_[i]);
        throw ciel::Error(name_ + ": declares \"" + declaration + "\"" +
                          (count < 0 ? ", a negative number: the file is damaged"
                                     : " but has only " + std::to_string(static_cast<std::uint64_t>(size_)) +
                                           " bytes: the file is damaged or cut short"));
    }

    bool declares_cells() const { // CELLS n size
        const auto cells = to_count(words_[2]);
        const auto size = to_count(words_[3]);
        if (!cells || !size || !is_one_of(words_[1], {"cells", "polygons", "vertices", "lines", "triangle_strips"}))
            return false;
        require(*cells, 1, 3);
        require(*size, 1, 3);
        return true;
    }

    bool declares_items() { // POINT_DATA n
        const auto count = to_count(words_[3]);
        if (!count) return false;
        const bool attributes = is_one_of(words_[2], {"point_data", "cell_data"});
        if (!attributes && words_[2] != "cell_types") return false;
        require(*count, bits_per_byte, 2);
        if (attributes) items_ = *count;
        return true;
    }

    bool declares_components() const {
        const auto count = to_count(words_[3]);
        if (!count) return false;
        if (words_[1] == "field") { // FIELD name arrays
            require(*count, 1, 3);
            return true;
        }
        if (words_[1] == "color_scalars") { // COLOR_SCALARS name components
            require(*count * items_, 1, 3);
            return true;
        }
        if (words_[0] != "scalars" || find_type(words_[2]) == nullptr) return false;
        require(*count * items_, bits_per_byte, 4); // SCALARS name type components
        return true;
    }

    std::uint64_t declared_values() const {
        const ValueType* type = find_type(words_[3]);
        const auto count = to_count(words_[2]);
        if (type == nullptr || !count) return 0;
        double values = *count;
        std::size_t length = 3;
        if (words_[1] == "points") { // POINTS n type
            values *= 3;
        } else if (words_[0] == "texture_coordinates") { // TEXTURE_COORDINATES name dimension type
            require(*count * items_, bits_per_byte, 4);
            return 0;
        } else if (const auto components = to_count(words_[1])) { // an array of a FIELD: name components n type
            values = *components < 0 ? *components : values * *components;
            length = 4;
        } else if (!is_one_of(words_[1], {"x_coordinates", "y_coordinates", "z_coordinates"})) {
            return 0;
        }
        require(values, type->name == "bit" ? bits_per_byte : 1, length);
        return static_cast<std::uint64_t>(values) * type->bytes;
    }

    double size_;
    const std::string& name_;
    std::array<std::string, 4> words_;
    double items_ = 0; // count of the last POINT_DATA or CELL_DATA
};

} // namespace

void check_legacy_vtk_counts(std::istream& file, std::uint64_t file_size, const std::string& name) {
    Words words(file);
    Check check(file_size, name);
    words.skip_line(); // the version
    words.skip_line(); // the title
    std::string word;
    const bool binary = words.next(word) && word == "binary";
    while (words.next(word)) {
        const std::uint64_t bytes = check.take(std::move(word));
        if (binary && bytes > 0) words.skip_values(bytes);
    }
}

} // namespace server::importer
