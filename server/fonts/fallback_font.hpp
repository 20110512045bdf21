// Finds an installed font that has a given character, through fontconfig.
#pragma once

#include <filesystem>
#include <optional>

namespace server::fonts {

struct FontFile {
    std::filesystem::path path;
    int index = 0; // index of the face in the file
};

// Returns the outline font that has the character and is most similar to DejaVu Sans, or nullopt. Thread-safe.
[[nodiscard]] std::optional<FontFile> fallback_font(char32_t character);

} // namespace server::fonts
