#include "fonts/free_type.hpp"

#include "ciel/types.hpp"

#include FT_MODULE_H

#include <cerrno>
#include <cstdlib>
#include <fcntl.h>
#include <new>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace server::fonts {
namespace {

FreeType& owner(FT_Memory memory) { return *static_cast<FreeType*>(memory->user); }

std::size_t size_of(int file) {
    struct stat status {};
    return ::fstat(file, &status) == 0 ? static_cast<std::size_t>(status.st_size) : 0;
}

} // namespace

void FreeType::Unmap::operator()(void* begin) const { ::munmap(begin, bytes); }

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

// Maps the file without FreeType's stream, because the stream hides why a mapping failed.
FreeType::Mapping FreeType::map(const std::filesystem::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (file < 0) return {};
    const std::size_t bytes = size_of(file);
    void* begin = ::mmap(nullptr, bytes, PROT_READ, MAP_PRIVATE, file, 0);
    const int failure = errno;
    ::close(file);
    if (begin != MAP_FAILED) return {begin, Unmap{bytes}};
    if (failure == ENOMEM) throw std::bad_alloc();
    return {};
}

FT_Face FreeType::open(const std::filesystem::path& file, int index) {
    Mapping bytes = map(file);
    if (!bytes) return nullptr;
    FT_Face face = nullptr;
    const FT_Error failed = FT_New_Memory_Face(library_, static_cast<const FT_Byte*>(bytes.get()),
                                               static_cast<FT_Long>(bytes.get_deleter().bytes), index, &face);
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
    throw ciel::Error("the font " + file.filename().string() + ": FreeType cannot " + what);
}

} // namespace server::fonts
