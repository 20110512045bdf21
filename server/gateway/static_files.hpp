// The web client's files, read into memory once. A request's path is a key of this table and never a name on the disk,
// so no path can lead out of the folder.
#pragma once

#include "gateway/http_message.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace ciel::gateway {

struct StaticFile {
    std::string content, mime, etag;
    std::string gzip, gzip_etag; // empty where compression saves nothing
    bool immutable = false;      // its name holds a hash of the content
};

class StaticFiles {
public:
    StaticFiles() = default;
    // Regular files below `root`, links that lead outside left out. Throws Error when `root` cannot be read or is
    // larger than a web client can be (64 MiB).
    explicit StaticFiles(const std::filesystem::path& root);

    // "/" is index.html. nullptr when there is no such file.
    [[nodiscard]] const StaticFile* find(std::string_view path) const;
    [[nodiscard]] std::size_t count() const { return files_.size(); }

private:
    std::map<std::string, StaticFile, std::less<>> files_; // by "/assets/index-1a2b3c4d.js"
};

[[nodiscard]] std::string_view mime_type(std::string_view extension); // ".js"; octets when it is not known
// Whether Accept-Encoding (RFC 9110, 12.5.3) takes gzip.
[[nodiscard]] bool accepts_gzip(std::string_view accept_encoding);
// 200, compressed where the client takes that, or 304 when if_none_match names the ETag of what it would get.
[[nodiscard]] Response file_response(const StaticFile& file, std::string_view if_none_match,
                                     std::string_view accept_encoding);

} // namespace ciel::gateway
