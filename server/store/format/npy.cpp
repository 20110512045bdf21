#include "store/format/npy.hpp"

#include "store/files/files.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace server::store {
namespace {

constexpr std::string_view magic{"\x93NUMPY", 6};
constexpr std::size_t largest_file = std::size_t{1} << 40;

struct Header {
    std::string_view dictionary;
    std::size_t data_begin = 0;
};

Header find_header(std::string_view text, const std::filesystem::path& file) {
    if (!text.starts_with(magic) || text.size() < 12) refuse(file, "is not a .npy file; save it with numpy.save");
    const auto byte = [&](std::size_t at) { return static_cast<std::size_t>(static_cast<unsigned char>(text[at])); };
    // The length of the header has two bytes in version 1, four bytes in versions 2 and 3.
    const bool is_long = byte(6) >= 2;
    std::size_t length = byte(8) | byte(9) << 8;
    if (is_long) length |= byte(10) << 16 | byte(11) << 24;
    const std::size_t begin = is_long ? 12 : 10;
    if (length > text.size() - begin) refuse(file, "ends inside its header; save the array again with numpy.save");
    return {text.substr(begin, length), begin + length};
}

std::string_view value_of(std::string_view dictionary, std::string_view key, const std::filesystem::path& file) {
    const std::string quoted = std::string("'").append(key).append("':");
    const auto at = dictionary.find(quoted);
    if (at == std::string_view::npos)
        refuse(file,
               std::string("has no '").append(key).append("' in its header; save the array again with numpy.save"));
    dictionary.remove_prefix(at + quoted.size());
    dictionary.remove_prefix(std::min(dictionary.find_first_not_of(' '), dictionary.size()));
    return dictionary;
}

std::vector<std::size_t> parse_shape(std::string_view text, const std::filesystem::path& file) {
    std::vector<std::size_t> shape;
    const auto end = text.find(')');
    if (!text.starts_with('(') || end == std::string_view::npos)
        refuse(file, "has a shape in its header that cannot be read; save the array again with numpy.save");
    const char *at = text.data() + 1, *const stop = text.data() + end;
    while (at < stop) {
        std::size_t extent = 0;
        const auto [after, error] = std::from_chars(at, stop, extent);
        if (error != std::errc())
            refuse(file, "has a shape in its header that cannot be read; save the array again with numpy.save");
        shape.push_back(extent);
        at = std::find_if(after, stop, [](char c) { return c != ',' && c != ' '; });
    }
    if (shape.empty() || shape.size() > 2)
        refuse(file, "must have one or two dimensions: values, or values x components");
    return shape;
}

template <typename T>
Values copied(std::string_view data) {
    std::vector<T> values(data.size() / sizeof(T));
    if (!values.empty()) std::memcpy(values.data(), data.data(), values.size() * sizeof(T));
    return Values(std::move(values));
}

} // namespace

NpyArray parse_npy(std::span<const std::byte> bytes, const std::filesystem::path& file) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const Header header = find_header(text, file);
    const bool is_double = value_of(header.dictionary, "descr", file).starts_with("'<f8'");
    if (!is_double && !value_of(header.dictionary, "descr", file).starts_with("'<f4'"))
        refuse(file, "holds neither float32 nor float64; convert it with astype('<f4')");
    if (!value_of(header.dictionary, "fortran_order", file).starts_with("False"))
        refuse(file, "is in Fortran order; save numpy.ascontiguousarray of the array");
    NpyArray array{parse_shape(value_of(header.dictionary, "shape", file), file), {}};

    const std::string_view data = text.substr(header.data_begin);
    std::size_t bytes_left = data.size(), size = is_double ? sizeof(double) : sizeof(float);
    for (const std::size_t extent : array.shape) {
        if (extent != 0 && size > bytes_left / extent)
            refuse(file, "is shorter than its header declares; save the array again");
        size *= extent;
    }
    if (size != bytes_left) refuse(file, "is longer than its header declares; save the array again");
    array.values = is_double ? copied<double>(data) : copied<float>(data);
    return array;
}

NpyArray read_npy(const std::filesystem::path& file) {
    return parse_npy(bytes_of(read_text(file, largest_file)), file);
}

} // namespace server::store
