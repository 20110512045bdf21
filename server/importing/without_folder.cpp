#include "importing/without_folder.hpp"

namespace server::importing {

std::string without_folder(std::string sentence, const std::filesystem::path& folder) {
    if (!folder.has_relative_path()) return sentence; // a bare name, or the root folder
    const std::string path = (folder / "").string(), name = folder.filename().string();
    for (auto at = sentence.find(path); at != std::string::npos; at = sentence.find(path, at))
        sentence.erase(at, path.size());
    for (auto at = sentence.find(folder.string()); at != std::string::npos;
         at = sentence.find(folder.string(), at + name.size()))
        sentence.replace(at, folder.string().size(), name);
    return sentence;
}

} // namespace server::importing
