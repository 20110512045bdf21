#include "import/readers/regular_file.hpp"

#include "ciel/types.hpp"

namespace server::importer {

namespace fs = std::filesystem;

void require_existing(const fs::path& file) {
    std::error_code error;
    const fs::file_status status = fs::status(file, error);
    if (fs::exists(status)) return;
    if (status.type() == fs::file_type::not_found)
        throw ciel::Error(file.string() + ": there is no such file or directory");
    throw ciel::Error(file.string() + ": cannot be examined: " + error.message());
}

void require_regular(const fs::path& file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
        throw ciel::Error(file.string() + ": is not a regular file but a pipe, a socket or a device");
}

void require_regular_files(const fs::path& directory) { require_regular_files(directory, ""); }

void require_regular_files(const fs::path& directory, std::string_view beginning) {
    std::error_code missing;
    for (const auto& entry : fs::directory_iterator(directory.empty() ? "." : directory, missing))
        if (entry.path().filename().string().starts_with(beginning)) require_regular(entry.path());
}

} // namespace server::importer
