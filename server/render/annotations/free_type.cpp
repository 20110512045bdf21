#include "render/annotations/free_type.hpp"

#include "ciel/types.hpp"

#include FT_MODULE_H

#include <boost/interprocess/file_mapping.hpp>
#include <cerrno>
#include <cstdlib>
#include <new>
#include <utility>

namespace ciel::render {
namespace {

namespace mapping = boost::interprocess;

FreeType& owner(FT_Memory memory) { return *static_cast<FreeType*>(memory->user); }

// Empty where there is no such file. FreeType's own stream hides why it could not map a file.
mapping::mapped_region mapped(const std::filesystem::path& file) {
    try {
        return {mapping::file_mapping(file.c_str(), mapping::read_only), mapping::read_only};
    } catch (const mapping::interprocess_exception& error) {
        if (error.get_native_error() == ENOMEM) throw std::bad_alloc();
        return {};
    }
}

} // namespace

FreeType::FreeType() : memory_{this, allocate, release, reallocate} {
    if (FT_New_Library(&memory_, &library_) != 0) throw std::bad_alloc();
    FT_Add_Default_Modules(library_);
}

FreeType::~FreeType() { FT_Done_Library(library_); }

void* FreeType::allocate(FT_Memory memory, long bytes) {
    void* block = std::malloc(static_cast<std::size_t>(bytes));
    if (block == nullptr) owner(memory).ran_out_ = true;
    return block;
}

void* FreeType::reallocate(FT_Memory memory, long /*before*/, long bytes, void* block) {
    void* moved = std::realloc(block, static_cast<std::size_t>(bytes));
    if (moved == nullptr) owner(memory).ran_out_ = true;
    return moved;
}

void FreeType::release(FT_Memory /*memory*/, void* block) { std::free(block); }

void FreeType::throw_if_out_of_memory() {
    if (std::exchange(ran_out_, false)) throw std::bad_alloc();
}

FT_Face FreeType::open(const std::filesystem::path& file, int index) {
    mapping::mapped_region bytes = mapped(file);
    FT_Face face = nullptr;
    const FT_Error failed = FT_New_Memory_Face(library_, static_cast<const FT_Byte*>(bytes.get_address()),
                                               static_cast<FT_Long>(bytes.get_size()), index, &face);
    if (failed != 0) {
        throw_if_out_of_memory();
        return nullptr;
    }
    files_.push_back(std::move(bytes));
    return face;
}

void FreeType::check(FT_Error error, const char* what, const std::filesystem::path& file) {
    if (error == 0) return;
    throw_if_out_of_memory();
    throw Error("this machine's font " + file.filename().string() + ": FreeType cannot " + what);
}

} // namespace ciel::render
