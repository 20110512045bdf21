// FreeType's library with an allocator that remembers what it could not give: FreeType reports a failed allocation as
// any of its errors, a damaged font among them, and a file that cannot be mapped as one of an unknown format. One
// thread at a time.
#pragma once

#include <filesystem>
#include <ft2build.h>
#include <memory>
#include <vector>
#include FT_FREETYPE_H
#include FT_SYSTEM_H

namespace ciel::fonts {

class FreeType {
public:
    FreeType();  // throws std::bad_alloc
    ~FreeType(); // with all faces that were opened
    FreeType(const FreeType&) = delete;
    FreeType& operator=(const FreeType&) = delete;

    [[nodiscard]] FT_Library library() const { return library_; }

    // Null where the file is no font that FreeType reads. Throws std::bad_alloc.
    [[nodiscard]] FT_Face open(const std::filesystem::path& file, int index);
    // Throws ciel::Error, naming the file and `what`, for an error; std::bad_alloc where memory was the reason.
    void check(FT_Error error, const char* what, const std::filesystem::path& file);

private:
    struct Unmap {
        std::size_t bytes = 0;
        void operator()(void* begin) const;
    };
    using Mapping = std::unique_ptr<void, Unmap>;

    static Mapping map(const std::filesystem::path& path); // null where it cannot be read
    static void* allocate(FT_Memory memory, long bytes);
    static void* reallocate(FT_Memory memory, long before, long bytes, void* block);
    static void release(FT_Memory memory, void* block);
    void throw_if_out_of_memory();

    FT_MemoryRec_ memory_;
    FT_Library library_ = nullptr;
    bool ran_out_ = false;
    std::vector<Mapping> files_; // faces read from them as long as they live
};

} // namespace ciel::fonts
