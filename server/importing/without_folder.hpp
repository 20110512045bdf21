// Removes paths from sentences. Clients must not learn paths of the server.
#pragma once

#include <filesystem>
#include <string>

namespace server::importing {

// Removes the path of `folder` from a sentence: the name of the folder remains, and the paths of its files below it.
[[nodiscard]] std::string without_folder(std::string sentence, const std::filesystem::path& folder);

} // namespace server::importing
