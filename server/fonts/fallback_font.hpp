// Finds another font of this machine that has a character, through fontconfig.
#pragma once

#include <filesystem>
#include <optional>

namespace ciel::fonts {

struct FontFile {
    std::filesystem::path path;
    int index = 0; // of the face in the file
};

// Returns the outline font most similar to the font of annotations; none if no font has the character. Thread-safe.
[[nodiscard]] std::optional<FontFile> fallback_font(char32_t character);

} // namespace ciel::fonts
