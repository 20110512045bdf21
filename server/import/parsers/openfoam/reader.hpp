// Reads the tokens of OpenFOAM's file format, text or binary (OpenFOAM User Guide, "Basic input/output file format").
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace server::importer {

struct FoamFormat {
    bool is_binary = false;
    int label_bytes = 4;
    int scalar_bytes = 8;
    std::string class_name; // such as "volScalarField"; empty if the file has no header
};

// The bytes must outlive the reader. If a token is not as expected, the functions throw Error with the byte offset.
class FoamReader {
public:
    // Reads the header (FoamFile) if the file has one. Throws Error if the header declares big-endian numbers.
    FoamReader(std::string_view bytes, std::string name);

    [[nodiscard]] const FoamFormat& format() const { return format_; }
    // Throws Error with the text "FILE: WHAT at byte OFFSET".
    [[noreturn]] void fail(const std::string& what) const;

    // The following functions first skip white space and comments.
    [[nodiscard]] bool at_end();
    [[nodiscard]] char peek(); // '\0' at the end of the file
    [[nodiscard]] bool accept(char c);
    void expect(char c);
    // Reads up to white space or one of ;{}()[]". A word may contain balanced parentheses: div(phi,U).
    [[nodiscard]] std::string_view word();
    [[nodiscard]] std::string_view name(bool& is_quoted);
    [[nodiscard]] double number(); // also accepts "nan" and "inf"
    [[nodiscard]] std::int64_t label();

    // Skips the value of an entry: a dictionary, or everything up to the semicolon.
    void skip_entry();

    // labels() and numbers() read a list: an optional "List<TYPE>", then "N(...)", "N{value}", or "(...)" without a
    // count. Both throw Error if N is larger than `most`.
    [[nodiscard]] std::vector<std::int64_t> labels(std::size_t most);
    [[nodiscard]] std::vector<double> numbers(int components, std::size_t most); // each item has `components` numbers
    // Reads the number of items of a list. Throws Error if this number is larger than `most`.
    [[nodiscard]] std::size_t items(std::size_t most);
    // Reads '(', then `bytes` raw bytes, then ')'. Returns the raw bytes.
    [[nodiscard]] std::string_view raw(std::size_t bytes);
    [[nodiscard]] std::size_t bytes_left() const { return bytes_.size() - at_; }

private:
    void read_header();
    void set_architecture(std::string_view text);
    void skip_space();
    void skip_quoted();
    void skip_list(std::string_view type);
    void read_item(int components, std::vector<double>& values);
    [[nodiscard]] std::string_view rest() const { return bytes_.substr(at_); }

    std::string_view bytes_;
    std::string file_;
    std::size_t at_ = 0;
    FoamFormat format_;
};

// Returns 3 for "vector", 6 for "symmTensor", and 0 for types that do not consist of scalars.
[[nodiscard]] int foam_components(std::string_view type);

} // namespace server::importer
