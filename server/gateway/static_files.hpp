// The web client's files, read into memory once. Request paths are keys of this table, not file names, so that no path
// can lead out of the folder.
#pragma once

#include "gateway/http_message.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace server::gateway {

struct StaticFile {
    std::string content, mime, etag;
    std::string gzip, gzip_etag; // empty if gzip saves nothing
    bool immutable = false;      // the name contains a hash of the content
};

class StaticFiles {
public:
    StaticFiles() = default;
    // Follows no links that lead outside `root`. Throws Error if `root` is unreadable or holds more than 64 MiB.
    explicit StaticFiles(const std::filesystem::path& root);

    // Returns the file of a request path ("/" is index.html), or nullptr if there is none.
    [[nodiscard]] const StaticFile* find(std::string_view path) const;
    [[nodiscard]] std::size_t count() const { return files_.size(); }

private:
    std::map<std::string, StaticFile, std::less<>> files_; // by request path, such as "/assets/index-1a2b3c4d.js"
};

// Returns the media type of an extension such as ".js"; application/octet-stream if it is unknown.
[[nodiscard]] std::string_view mime_type(std::string_view extension);
// Returns whether an Accept-Encoding header (RFC 9110, 12.5.3) allows gzip.
[[nodiscard]] bool accepts_gzip(std::string_view accept_encoding);
// Returns status 304 without a body if `if_none_match` contains the ETag of this answer.
[[nodiscard]] Response file_response(const StaticFile& file, std::string_view if_none_match,
                                     std::string_view accept_encoding);

} // namespace server::gateway
