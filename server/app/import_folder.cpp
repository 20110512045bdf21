#include "app/import_folder.hpp"

#include <cstdlib>

namespace server::app {

std::filesystem::path default_import_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache != '\0')
        return std::filesystem::path(cache) / "ciel";
    const char* home = std::getenv("HOME");
    return std::filesystem::path(home != nullptr ? home : ".") / ".cache" / "ciel";
}

} // namespace server::app
