// Removes paths from sentences. Clients must not learn paths of the server.
#pragma once

#include <filesystem>
#include <string>

namespace server::importing {

// Files in `folder` keep their path below it, and the folder itself keeps its name.
[[nodiscard]] std::string without_folder(std::string sentence, const std::filesystem::path& folder);

} // namespace server::importing
