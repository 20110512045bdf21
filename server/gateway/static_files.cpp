#include "gateway/static_files.hpp"

#include "ciel/types.hpp"
#include "gateway/header_text.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <iterator>
#include <zlib.h>

namespace server::gateway {
namespace {

constexpr std::size_t size_limit = 64 << 20;

constexpr std::array<std::pair<std::string_view, std::string_view>, 18> mime_types{{
    {".css", "text/css; charset=utf-8"},
    {".gif", "image/gif"},
    {".html", "text/html; charset=utf-8"},
    {".ico", "image/x-icon"},
    {".jpg", "image/jpeg"},
    {".js", "text/javascript; charset=utf-8"},
    {".json", "application/json"},
    {".map", "application/json"},
    {".mjs", "text/javascript; charset=utf-8"},
    {".png", "image/png"},
    {".svg", "image/svg+xml"},
    {".ttf", "font/ttf"},
    {".txt", "text/plain; charset=utf-8"},
    {".wasm", "application/wasm"},
    {".webmanifest", "application/manifest+json"},
    {".webp", "image/webp"},
    {".woff", "font/woff"},
    {".woff2", "font/woff2"},
}};

// 64-bit FNV-1a hash; it only has to distinguish versions of one file.
std::string content_tag(std::string_view content) {
    std::uint64_t hash = 14695981039346656037U;
    for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211U;
    std::string tag(1, '"');
    for (int shift = 60; shift >= 0; shift -= 4) tag += "0123456789abcdef"[(hash >> shift) & 15];
    tag += '"';
    return tag;
}

// Excludes images and most fonts, because their formats are already compressed.
bool is_compressible(std::string_view mime) {
    return mime.starts_with("text/") || mime == "application/json" || mime == "application/wasm" ||
           mime == "application/manifest+json" || mime == "image/svg+xml" || mime == "image/x-icon" ||
           mime == "font/ttf";
}

// Returns an empty text if the result would not be smaller.
std::string gzipped(const std::string& content) {
    z_stream stream{};
    constexpr int gzip_header = 16, memory_level = 8;
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, MAX_WBITS + gzip_header, memory_level,
                     Z_DEFAULT_STRATEGY) != Z_OK)
        return {};
    std::string out(content.size(), '\0'); // a larger result is not used
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(content.data()));
    stream.avail_in = static_cast<uInt>(content.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    const bool fits = deflate(&stream, Z_FINISH) == Z_STREAM_END;
    out.resize(fits ? stream.total_out : 0);
    deflateEnd(&stream);
    return out;
}

double weight_of(std::string_view coding) {
    double weight = 1;
    any_item(coding, ';', [&](std::string_view parameter) {
        if (parameter.size() < 2 || lower(parameter[0]) != 'q' || parameter[1] != '=') return false;
        const auto number = parameter.substr(2);
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), weight);
        if (error != std::errc()) weight = 0;
        return true;
    });
    return weight;
}

// The build of the web client puts a content hash of 8 characters into the names of files: assets/NAME-HASH.EXT.
bool is_hashed(const std::filesystem::path& relative) {
    const std::string stem = relative.stem().string();
    const auto dash = stem.size() < 9 ? std::string::npos : stem.size() - 9;
    return relative.parent_path() == "assets" && dash != std::string::npos && stem[dash] == '-';
}

bool is_below(const std::filesystem::path& path, const std::filesystem::path& root) {
    return std::mismatch(root.begin(), root.end(), path.begin(), path.end()).first == root.end();
}

} // namespace

StaticFiles::StaticFiles(const std::filesystem::path& root) {
    namespace fs = std::filesystem;
    std::error_code failure;
    const fs::path base = fs::canonical(root, failure);
    if (failure || !fs::is_directory(base))
        throw ciel::Error("the web client's folder " + root.string() +
                          " cannot be read; build the web client, or name its folder with --webclient");
    std::size_t total = 0;
    for (const auto& entry : fs::recursive_directory_iterator(base)) {
        if (!entry.is_regular_file(failure)) continue;
        if (!is_below(fs::canonical(entry.path(), failure), base) || failure) continue;
        std::ifstream stream(entry.path(), std::ios::binary);
        StaticFile file;
        file.content.assign(std::istreambuf_iterator<char>(stream), {});
        if ((total += file.content.size()) > size_limit)
            throw ciel::Error(
                root.string() +
                " holds more than 64 MiB and is not a web client; name the folder of the web client with --webclient");
        const fs::path relative = entry.path().lexically_relative(base);
        file.mime = mime_type(relative.extension().string());
        file.etag = content_tag(file.content);
        if (is_compressible(file.mime)) file.gzip = gzipped(file.content);
        if (!file.gzip.empty()) file.gzip_etag = content_tag(file.gzip);
        file.immutable = is_hashed(relative);
        files_.emplace((fs::path("/") / relative).generic_string(), std::move(file));
    }
}

const StaticFile* StaticFiles::find(std::string_view path) const {
    const auto found = files_.find(path == "/" ? "/index.html" : path);
    return found == files_.end() ? nullptr : &found->second;
}

std::string_view mime_type(std::string_view extension) {
    const auto found =
        std::find_if(mime_types.begin(), mime_types.end(), [&](const auto& row) { return row.first == extension; });
    return found == mime_types.end() ? "application/octet-stream" : found->second;
}

bool accepts_gzip(std::string_view accept_encoding) {
    double gzip = -1, any = 0;
    any_item(accept_encoding, ',', [&](std::string_view coding) {
        const auto name = trimmed(coding.substr(0, coding.find(';')));
        if (same_ignoring_case(name, "gzip") || same_ignoring_case(name, "x-gzip")) gzip = weight_of(coding);
        if (name == "*") any = weight_of(coding);
        return false;
    });
    return (gzip < 0 ? any : gzip) > 0;
}

Response file_response(const StaticFile& file, std::string_view if_none_match, std::string_view accept_encoding) {
    const bool compressed = !file.gzip.empty() && accepts_gzip(accept_encoding);
    const std::string& etag = compressed ? file.gzip_etag : file.etag;
    Response response;
    response.content_type = file.mime;
    response.headers.emplace_back("ETag", etag);
    response.headers.emplace_back("Cache-Control", file.immutable ? "public, max-age=31536000, immutable" : "no-cache");
    if (!file.gzip.empty()) response.headers.emplace_back("Vary", "Accept-Encoding");
    if (if_none_match == "*" || if_none_match.find(etag) != std::string_view::npos) {
        response.status = 304;
        return response;
    }
    if (compressed) response.headers.emplace_back("Content-Encoding", "gzip");
    response.body = compressed ? file.gzip : file.content;
    return response;
}

} // namespace server::gateway
