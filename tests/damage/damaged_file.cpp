#include "damage/damaged_file.hpp"

#include <algorithm>
#include <fcntl.h>
#include <fstream>
#include <random>
#include <stdexcept>
#include <sys/stat.h>
#include <unistd.h>

namespace ciel::test {
namespace {

namespace fs = std::filesystem;

class OpenFile {
public:
    explicit OpenFile(const fs::path& path) : descriptor_(::open(path.c_str(), O_RDWR | O_CLOEXEC)) {
        if (descriptor_ < 0) throw std::runtime_error(path.string() + " cannot be opened");
    }
    ~OpenFile() { ::close(descriptor_); }
    OpenFile(const OpenFile&) = delete;

    [[nodiscard]] std::size_t size() const {
        struct stat status {};
        ::fstat(descriptor_, &status);
        return static_cast<std::size_t>(status.st_size);
    }
    void resize(std::size_t bytes) const { check(::ftruncate(descriptor_, static_cast<off_t>(bytes)) == 0); }
    void write(std::size_t at, const std::string& bytes) const {
        check(::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(at)) ==
              static_cast<ssize_t>(bytes.size()));
    }
    [[nodiscard]] char read(std::size_t at) const {
        char byte = 0;
        check(::pread(descriptor_, &byte, 1, static_cast<off_t>(at)) == 1);
        return byte;
    }

private:
    static void check(bool holds) {
        if (!holds) throw std::runtime_error("a file cannot be damaged");
    }
    int descriptor_;
};

} // namespace

std::string name_of(Damage damage) {
    switch (damage) {
    case Damage::truncated:
        return "truncated";
    case Damage::halved:
        return "halved";
    case Damage::overwritten:
        return "overwritten";
    case Damage::ones:
        return "ones";
    case Damage::flipped:
        return "flipped";
    }
    return {};
}

void damage(const fs::path& path, Damage how, unsigned seed) {
    constexpr int flips = 200;
    const OpenFile file(path);
    const std::size_t size = file.size();
    std::mt19937 random(seed);
    switch (how) {
    case Damage::truncated:
        return file.resize(0);
    case Damage::halved:
        return file.resize(size / 2);
    case Damage::overwritten: {
        std::string noise(size, '\0');
        for (char& byte : noise) byte = static_cast<char>(random());
        return file.write(0, noise);
    }
    case Damage::ones:
        return file.write(0, std::string(size, '\xff'));
    case Damage::flipped:
        for (int i = 0; i < flips && size > 0; ++i) {
            const std::size_t at = random() % size;
            file.write(at, std::string(1, static_cast<char>(file.read(at) ^ (1 << random() % 8))));
        }
    }
}

void rewrite(const fs::path& path, const std::string& content) {
    const OpenFile file(path);
    file.resize(content.size());
    file.write(0, content);
}

void replace(const fs::path& path, const std::string& content) {
    const fs::path aside = path.string() + ".aside";
    std::ofstream(aside, std::ios::binary) << content;
    fs::rename(aside, path);
}

std::vector<fs::path> mapped_files_in(const fs::path& dataset) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::recursive_directory_iterator(dataset / "meshes")) {
        const std::string name = entry.path().filename().string();
        const bool is_moved = name.front() == '1' && entry.path().parent_path().filename() == "positions";
        if (entry.is_regular_file() && (name.front() == '0' || is_moved) && entry.file_size() > 0)
            files.push_back(fs::relative(entry.path(), dataset));
    }
    std::sort(files.begin(), files.end());
    return files;
}

bool holds_indices(const fs::path& relative) {
    const std::string path = relative.string();
    return path.find("/arrays/") == std::string::npos && path.find("/positions/") == std::string::npos &&
           path.find("/ranges/") == std::string::npos; // read once: later damage is not noticed
}

} // namespace ciel::test
