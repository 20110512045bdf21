// FreeType: an FT_Library whose allocator records failed allocations, because FreeType itself reports them as arbitrary
// errors, for example as a damaged font. Not thread-safe.
#pragma once

#include <filesystem>
#include <ft2build.h>
#include <memory>
#include <vector>
#include FT_FREETYPE_H
#include FT_SYSTEM_H

namespace server::fonts {

class FreeType {
public:
    FreeType();  // throws std::bad_alloc
    ~FreeType(); // closes all faces
    FreeType(const FreeType&) = delete;
    FreeType& operator=(const FreeType&) = delete;

    [[nodiscard]] FT_Library library() const { return library_; }

    // This object owns the face. Returns null if FreeType cannot read the font. Throws std::bad_alloc.
    [[nodiscard]] FT_Face open(const std::filesystem::path& file, int index);
    // Does nothing if `error` is 0. Otherwise throws std::bad_alloc if an allocation failed, else ciel::Error with the
    // name of the file and the failed action `what`.
    void check(FT_Error error, const char* what, const std::filesystem::path& file);

private:
    struct Unmap {
        std::size_t bytes = 0;
        void operator()(void* begin) const;
    };
    using Mapping = std::unique_ptr<void, Unmap>;

    static Mapping map(const std::filesystem::path& path); // null if the file cannot be read
    static void* allocate(FT_Memory memory, long bytes);
    static void* reallocate(FT_Memory memory, long before, long bytes, void* block);
    static void release(FT_Memory memory, void* block);
    void throw_if_out_of_memory();

    FT_MemoryRec_ memory_;
    FT_Library library_ = nullptr;
    bool ran_out_ = false;       // an allocation has failed
    std::vector<Mapping> files_; // must outlive the faces
};

} // namespace server::fonts
