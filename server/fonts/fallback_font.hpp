// Which other font of this machine has a character, through fontconfig.
#pragma once

#include <filesystem>
#include <optional>

namespace ciel::fonts {

struct FontFile {
    std::filesystem::path path;
    int index = 0; // of the face in the file
};

// The nearest to the font of annotations among those with outlines; none where no font has the character. Any thread.
[[nodiscard]] std::optional<FontFile> fallback_font(char32_t character);

} // namespace ciel::fonts
