// OpenFOAM's file format, as text or binary (OpenFOAM User Guide, "Basic input/output file format"): the header, words,
// numbers and lists. The parsers of this folder are made of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

struct FoamFormat {
    bool is_binary = false;
    int label_bytes = 4;
    int scalar_bytes = 8;
    std::string class_name; // "volScalarField"; empty without a header
};

// Reads forward through the bytes of one file, which outlive it. All functions throw Error naming the file and the byte
// where they find something else.
class FoamReader {
public:
    // Reads the header (FoamFile), where there is one. Big-endian binary files are refused.
    FoamReader(std::string_view bytes, std::string name);

    [[nodiscard]] const FoamFormat& format() const { return format_; }
    [[noreturn]] void fail(const std::string& what) const;

    // Before each of these, white space and comments are passed over.
    [[nodiscard]] bool at_end();
    [[nodiscard]] char peek(); // 0 at the end
    [[nodiscard]] bool accept(char c);
    void expect(char c);
    [[nodiscard]] std::string_view word(); // up to white space or one of ;{}()[]"; brackets within a word are kept
    [[nodiscard]] std::string_view name(bool& is_quoted);
    [[nodiscard]] double number(); // "nan" and "inf" too
    [[nodiscard]] std::int64_t label();

    // What follows a keyword: up to its semicolon, or a dictionary.
    void skip_entry();

    // "List<TYPE>" where it stands, then "N(...)", "N{value}", or "(...)" without a count. Of more than `most` items
    // they throw.
    [[nodiscard]] std::vector<std::int64_t> labels(std::size_t most);
    [[nodiscard]] std::vector<double> numbers(int components, std::size_t most); // `components` of them an item
    // How many items a list says it has; not more than `most`.
    [[nodiscard]] std::size_t items(std::size_t most);
    // `bytes` raw bytes behind an opening bracket and before the closing one.
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

// Numbers of a type's value: "vector" 3, "symmTensor" 6. 0 for types that are not of numbers.
[[nodiscard]] int foam_components(std::string_view type);

} // namespace ciel::importer
