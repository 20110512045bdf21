#include "fonts/fallback_font.hpp"

#include <fontconfig/fontconfig.h>
#include <memory>

namespace server::fonts {
namespace {

template <auto destroy>
struct Destroy {
    template <class T>
    void operator()(T* owned) const {
        destroy(owned);
    }
};
using Config = std::unique_ptr<FcConfig, Destroy<FcConfigDestroy>>;
using Pattern = std::unique_ptr<FcPattern, Destroy<FcPatternDestroy>>;
using CharSet = std::unique_ptr<FcCharSet, Destroy<FcCharSetDestroy>>;

// Returns the fonts that were installed at the first call; null if fontconfig has no configuration.
FcConfig* installed() {
    static const Config config(FcInitLoadConfigAndFonts());
    return config.get();
}

const FcChar8* text(const char* ascii) { return reinterpret_cast<const FcChar8*>(ascii); }

} // namespace

std::optional<FontFile> fallback_font(char32_t character) {
    if (installed() == nullptr) return {};
    const CharSet wanted(FcCharSetCreate());
    FcCharSetAddChar(wanted.get(), character);
    const Pattern pattern(FcPatternCreate());
    FcPatternAddString(pattern.get(), FC_FAMILY, text("DejaVu Sans"));
    FcPatternAddString(pattern.get(), FC_FAMILY, text("sans-serif"));
    FcPatternAddCharSet(pattern.get(), FC_CHARSET, wanted.get());
    FcPatternAddBool(pattern.get(), FC_OUTLINE, FcTrue);
    FcPatternAddBool(pattern.get(), FC_COLOR, FcFalse);
    FcConfigSubstitute(installed(), pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    FcResult result = FcResultNoMatch;
    const Pattern best(FcFontMatch(installed(), pattern.get(), &result));
    if (!best) return {};
    FcCharSet* has = nullptr;
    FcChar8* file = nullptr;
    int index = 0;
    if (FcPatternGetCharSet(best.get(), FC_CHARSET, 0, &has) != FcResultMatch || FcCharSetHasChar(has, character) == 0)
        return {}; // no font has the character
    if (FcPatternGetString(best.get(), FC_FILE, 0, &file) != FcResultMatch) return {};
    FcPatternGetInteger(best.get(), FC_INDEX, 0, &index);
    return FontFile{reinterpret_cast<const char*>(file), index};
}

} // namespace server::fonts
