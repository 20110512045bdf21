// extract_everywhere CASES RESULTS: the extraction as a program that reads and writes files.
#include "wasm/extract_everywhere.hpp"

#include <fstream>
#include <iostream>
#include <iterator>

int main(int count, char** arguments) {
    if (count != 3) {
        std::cerr << "extract_everywhere: give the file of cases (wasm_cases writes it) and the file to write\n";
        return 2;
    }
    std::ifstream file(arguments[1], std::ios::binary);
    const std::vector<char> cases{std::istreambuf_iterator<char>(file), {}};
    const ciel::test::Bytes results = ciel::test::extract_everywhere(std::as_bytes(std::span(cases)));
    std::ofstream out(arguments[2], std::ios::binary);
    out.write(reinterpret_cast<const char*>(results.data()), static_cast<std::streamsize>(results.size()));
    return file && out.flush() ? 0 : 1;
}
