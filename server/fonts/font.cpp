#include "fonts/font.hpp"

#include "ciel/types.hpp"
#include "fonts/fallback_font.hpp"
#include "fonts/free_type.hpp"

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_GLYPH_H
#include FT_STROKER_H

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>
#include <utility>

namespace server::fonts {
namespace {

constexpr FT_Int32 load_flags = FT_LOAD_TARGET_LIGHT; // hints only vertically, so that letters keep their shapes
constexpr double halo_share = 0.09;                   // width of the halo around a letter, in ems
constexpr unsigned face_shift = 24;                   // PlacedGlyph::glyph is (face << face_shift) | glyph in the face
constexpr std::uint32_t glyph_mask = (1U << face_shift) - 1;
constexpr std::size_t most_faces = 64;

struct GlyphDeleter {
    void operator()(FT_Glyph glyph) const { FT_Done_Glyph(glyph); }
};
using OwnedGlyph = std::unique_ptr<FT_GlyphRec_, GlyphDeleter>;

OwnedGlyph bitmap_of(OwnedGlyph outline, FreeType& library, const std::filesystem::path& file) {
    FT_Glyph glyph = outline.release();
    const FT_Error error = FT_Glyph_To_Bitmap(&glyph, FT_RENDER_MODE_NORMAL, nullptr, 1);
    OwnedGlyph owned(glyph);
    library.check(error, "draw a glyph", file);
    return owned;
}

void copy(const FT_BitmapGlyphRec_& from, GlyphImage& to, std::size_t channel) {
    const FT_Bitmap& bitmap = from.bitmap;
    for (unsigned row = 0; row < bitmap.rows; ++row)
        for (unsigned column = 0; column < bitmap.width; ++column) {
            const int x = from.left - to.left + static_cast<int>(column);
            const int y = to.top - from.top + static_cast<int>(row);
            if (x < 0 || y < 0 || x >= to.width || y >= to.height) continue;
            const auto at =
                2 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(to.width) + static_cast<std::size_t>(x));
            to.coverage[at + channel] = bitmap.buffer[static_cast<std::ptrdiff_t>(row) * bitmap.pitch + column];
        }
}

} // namespace

struct Font::State {
    FreeType library;
    FT_Stroker stroker = nullptr;
    struct Face {
        std::filesystem::path file;
        int index = 0; // index of the face in the file
        FT_Face face = nullptr;
        int pixels = 0; // current size of the face, in pixels per em
    };
    std::vector<Face> faces; // the font, then fallback fonts
    struct Character {
        std::uint32_t glyph = 0; // the same number as in PlacedGlyph::glyph
        double advance = 0;      // in ems
    };
    std::unordered_map<char32_t, Character> characters; // cache, because a look-up in the file takes microseconds
    std::map<int, annotations::FontMetrics> metrics;

    explicit State(const std::filesystem::path& file) {
        if (!open(file, 0))
            throw ciel::Error(
                "titles, axes and legends cannot be drawn: the font " + file.filename().string() +
                " cannot be read on the server; install the package fonts-dejavu-core there, or leave out "
                "titles, axes and legends");
        library.check(FT_Stroker_New(library.library(), &stroker), "outline its glyphs", file);
    }
    // Returns false if the file is not a readable font. Throws std::bad_alloc if memory is exhausted.
    bool open(const std::filesystem::path& file, int index) {
        const FT_Face face = library.open(file, index);
        if (face == nullptr) return false;
        faces.push_back({file, index, face, 0});
        return true;
    }
    // Returns the index of a face and the character's glyph in this face. If no face has the character, returns {0, 0}:
    // the box that the font shows for missing characters.
    std::pair<std::size_t, FT_UInt> find(char32_t character) {
        for (std::size_t i = 0; i < faces.size(); ++i)
            if (const FT_UInt glyph = FT_Get_Char_Index(faces[i].face, character); glyph != 0) return {i, glyph};
        const auto other = faces.size() < most_faces ? fallback_font(character) : std::nullopt;
        if (!other || !open(other->path, other->index)) return {0, 0};
        const FT_UInt glyph = FT_Get_Char_Index(faces.back().face, character);
        return glyph == 0 ? std::pair<std::size_t, FT_UInt>{0, 0} : std::pair{faces.size() - 1, glyph};
    }
    ~State() { FT_Stroker_Done(stroker); }
    State(const State&) = delete;
    State& operator=(const State&) = delete;
};

Font::Font(std::filesystem::path file) : file_(std::move(file)) {}
Font::~Font() = default;
Font::Font(Font&&) noexcept = default;

std::filesystem::path Font::default_file() { return CIEL_FONT; }

Font::State& Font::opened() {
    if (!state_) state_ = std::make_unique<State>(file_);
    return *state_;
}

FT_FaceRec_* Font::at(int pixels, std::size_t place) {
    State& state = opened();
    State::Face& known = state.faces.at(place);
    if (known.pixels != pixels) {
        state.library.check(FT_Set_Pixel_Sizes(known.face, 0, static_cast<FT_UInt>(pixels)), "scale the font",
                            known.file);
        known.pixels = pixels;
    }
    return known.face;
}

annotations::FontMetrics Font::metrics(int pixels) {
    State& known = opened();
    if (const auto found = known.metrics.find(pixels); found != known.metrics.end()) return found->second;
    const FT_Face face = at(pixels, 0);
    annotations::FontMetrics metrics;
    metrics.ascent = static_cast<int>((face->size->metrics.ascender + 63) / 64);
    metrics.descent = static_cast<int>((-face->size->metrics.descender + 63) / 64);
    known.library.check(FT_Load_Char(face, '0', load_flags), "read its digits", file_);
    metrics.digit = static_cast<int>((face->glyph->metrics.horiBearingY + 32) / 64);
    return known.metrics[pixels] = metrics;
}

Line Font::shape(std::string_view utf8, int pixels) {
    State& state = opened();
    Line line;
    double pen = 0; // in ems; not rounded, because rounding after each glyph would spoil the spacing
    std::uint32_t before = 0;
    for (const char32_t character : decode_utf8(utf8)) {
        auto known = state.characters.find(character);
        if (known == state.characters.end()) {
            const bool is_control = character < 0x20 || (character >= 0x7F && character < 0xA0);
            const auto [place, glyph] = state.find(is_control ? U' ' : character);
            const State::Face& own = state.faces[place];
            state.library.check(FT_Load_Glyph(own.face, glyph, FT_LOAD_NO_SCALE), "read a glyph", own.file);
            const double advance = static_cast<double>(own.face->glyph->metrics.horiAdvance) / own.face->units_per_EM;
            const auto packed = static_cast<std::uint32_t>(place << face_shift | glyph);
            known = state.characters.emplace(character, State::Character{packed, advance}).first;
        }
        const auto [glyph, advance] = known->second;
        const FT_Face face = state.faces[glyph >> face_shift].face;
        FT_Vector kerning{};
        if (before != 0 && glyph != 0 && before >> face_shift == glyph >> face_shift)
            FT_Get_Kerning(face, before & glyph_mask, glyph & glyph_mask, FT_KERNING_UNSCALED, &kerning);
        pen += static_cast<double>(kerning.x) / face->units_per_EM;
        line.glyphs.push_back({glyph, static_cast<int>(std::lround(pen * pixels))});
        pen += advance;
        before = glyph;
    }
    line.width = static_cast<int>(std::ceil(pen * pixels));
    return line;
}

GlyphImage Font::draw(std::uint32_t glyph, int pixels) {
    const std::size_t place = glyph >> face_shift;
    const FT_Face face = at(pixels, place);
    State& state = opened();
    const std::filesystem::path& file = state.faces[place].file;
    GlyphImage image;
    state.library.check(FT_Load_Glyph(face, glyph & glyph_mask, load_flags), "read a glyph", file);
    if (face->glyph->format != FT_GLYPH_FORMAT_OUTLINE || face->glyph->outline.n_points == 0) return image;
    FT_Glyph loaded = nullptr;
    state.library.check(FT_Get_Glyph(face->glyph, &loaded), "read a glyph", file);
    OwnedGlyph letter(loaded);
    FT_Stroker_Set(state.stroker, static_cast<FT_Fixed>(64 * std::max(1.0, halo_share * pixels)),
                   FT_STROKER_LINECAP_ROUND, FT_STROKER_LINEJOIN_ROUND, 0);
    FT_Glyph stroked = loaded;
    state.library.check(FT_Glyph_StrokeBorder(&stroked, state.stroker, 0, 0), "outline a glyph",
                        file); // last argument 0: keeps `loaded`
    const OwnedGlyph halo = bitmap_of(OwnedGlyph(stroked), state.library, file);
    letter = bitmap_of(std::move(letter), state.library, file);
    const auto& around = *reinterpret_cast<FT_BitmapGlyph>(halo.get());
    image.left = around.left;
    image.top = around.top;
    image.width = static_cast<int>(around.bitmap.width);
    image.height = static_cast<int>(around.bitmap.rows);
    image.coverage.assign(2 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height), 0);
    copy(*reinterpret_cast<FT_BitmapGlyph>(letter.get()), image, 0);
    copy(around, image, 1);
    return image;
}

} // namespace server::fonts
