#include "store/format/layout.hpp"

#include "store/files/files.hpp"
#include "store/format/checksum.hpp"

namespace server::store::layout {
namespace {
constexpr std::size_t longest_directory_name = 200; // in bytes; file systems allow 255
}

std::filesystem::path mesh(const std::filesystem::path& dataset, std::size_t mesh) {
    return dataset / "meshes" / std::to_string(mesh);
}

std::filesystem::path face_or_cell_group(const std::filesystem::path& mesh, std::size_t index) {
    return mesh / "groups" / std::to_string(index);
}

std::filesystem::path values(const std::filesystem::path& mesh, const std::string& array) {
    return mesh / "arrays" / encode_name(array);
}

std::filesystem::path chunk(const std::filesystem::path& array, std::uint64_t first, std::size_t rank) {
    std::string name = std::to_string(first);
    for (std::size_t i = 1; i < rank; ++i) name += ".0";
    return array / name;
}

std::filesystem::path block_index(const std::filesystem::path& mesh) { return mesh / "blocks" / "index"; }

std::filesystem::path records(const std::filesystem::path& mesh, ciel::RecordKind kind, std::size_t number) {
    const char* const folder = kind == ciel::RecordKind::cells    ? "cells"
                               : kind == ciel::RecordKind::around ? "around"
                                                                  : "mates";
    return mesh / "blocks" / folder / std::to_string(number);
}

std::filesystem::path value_ranges(const std::filesystem::path& array, std::uint64_t chunk) {
    return array / "ranges" / std::to_string(chunk);
}

std::filesystem::path late_facts(const std::filesystem::path& array, std::uint64_t chunk) {
    return array / "late" / std::to_string(chunk);
}

std::string encode_name(const std::string& name) {
    constexpr const char* digits = "0123456789ABCDEF";
    std::string encoded;
    for (const char c : name) {
        const bool plain =
            (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
        if (plain) {
            encoded += c;
        } else {
            const auto byte = static_cast<unsigned char>(c);
            encoded += {'%', digits[byte >> 4], digits[byte & 15]};
        }
    }
    if (encoded.size() > longest_directory_name) {
        const std::string hash = checksum(bytes_of(name));
        encoded = encoded.substr(0, longest_directory_name - 20) + "%~" + hash.substr(hash.size() - 16);
    }
    return encoded.empty() ? "%" : encoded;
}

} // namespace server::store::layout
