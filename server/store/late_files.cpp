#include "store/late_files.hpp"

#include "store/files/files.hpp"
#include "store/format/attributes.hpp"
#include "store/format/checksum.hpp"
#include "store/format/layout.hpp"

#include <unistd.h>
#include <utility>
#include <vector>

namespace server::store {
namespace {

namespace fs = std::filesystem;

constexpr const char* dataset_file = "dataset"; // beside late files outside their dataset: the path of the dataset

bool is_there(const fs::path& file) {
    std::error_code error;
    return fs::exists(file, error);
}

// Returns whether the dataset was removed or replaced. `late`: directory of its late files, named by the dataset's id.
bool is_forgotten(const fs::path& late) {
    const fs::path name = late / dataset_file;
    if (!is_there(name)) return false; // written by an earlier version; kept, because the dataset is not known
    const fs::path dataset = read_text(name, layout::document_bytes);
    const fs::path attributes = dataset / layout::attributes_document;
    if (!is_there(attributes)) return !is_there(dataset) && is_there(dataset.parent_path());
    return parse_root_attributes(read_text(attributes, layout::document_bytes), attributes).id != late.filename();
}

} // namespace

LateFiles::LateFiles(fs::path dataset, const fs::path& folder, const std::string& dataset_id)
    : dataset_(std::move(dataset)), elsewhere_(folder.empty() ? fs::path() : folder / dataset_id) {}

fs::path LateFiles::elsewhere(const fs::path& directory) const {
    return elsewhere_ / directory.lexically_relative(dataset_);
}

ArrayLayout LateFiles::layout_of(const ArrayLayout& array, std::uint64_t chunk) const {
    ArrayLayout found = array;
    if (!elsewhere_.empty() && !is_there(array.chunk(chunk))) found.directory = elsewhere(array.directory);
    return found;
}

// Returns nullopt if the source has no such array at this step, and `entry` itself if it has not been written yet.
std::optional<MarkedArray> LateFiles::complete(const ArrayLayout& array, MarkedArray entry) const {
    std::vector<fs::path> directories{array.directory};
    if (!elsewhere_.empty()) directories.push_back(elsewhere(array.directory));
    for (const fs::path& directory : directories) {
        ArrayLayout at = array;
        at.directory = directory;
        const fs::path facts = layout::late_facts(directory, entry.chunk);
        const bool is_written = is_there(at.chunk(entry.chunk)), has_facts = is_there(facts);
        std::optional<MarkedArray> known = entry;
        try {
            if (has_facts) known = parse_late_facts(read_text(facts, layout::document_bytes), facts, entry.chunk);
        } catch (const ciel::Error&) { // a damaged file: the array stays late, and is read from the source again
            return entry;
        }
        if (!known) return std::nullopt;
        if (!is_written) continue;
        known->late = false;
        return known;
    }
    return entry;
}

void LateFiles::complete(MarkedStep& step, const std::map<std::string, ArrayLayout>& arrays) const {
    for (auto entry = step.arrays.begin(); entry != step.arrays.end();) {
        const auto array = arrays.find(entry->first);
        const auto known = entry->second.late && array != arrays.end() ? complete(array->second, entry->second)
                                                                       : std::optional(entry->second);
        if (known) {
            entry->second = *known;
            ++entry;
        } else {
            entry = step.arrays.erase(entry);
        }
    }
}

std::uint64_t LateFiles::changes() const {
    std::string texts;
    for (const fs::path& directory : {dataset_, elsewhere_})
        if (const fs::path file = directory / layout::late_changes; !directory.empty() && is_there(file))
            texts += read_text(file, layout::document_bytes) + "\n";
    return texts.empty() ? 0 : checksum_number(std::as_bytes(std::span(texts)));
}

fs::path LateFiles::writable() const {
    const bool is_writable =
        ::access(dataset_.c_str(), W_OK) == 0 && ::access((dataset_ / "meshes").c_str(), W_OK) == 0;
    if (!is_writable && elsewhere_.empty())
        refuse(dataset_, "cannot be written to, and there is no folder for values that are read after the import; make "
                         "the directory writable, or give --late-folder");
    return is_writable ? dataset_ : elsewhere_;
}

void LateFiles::name_dataset() const {
    replace_file(elsewhere_ / dataset_file, bytes_of(fs::absolute(dataset_).lexically_normal().string()));
}

void remove_forgotten_late_files(const fs::path& folder) noexcept {
    std::error_code error;
    for (auto entry = fs::directory_iterator(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error)) {
        std::error_code ignored;
        try {
            if (is_forgotten(entry->path())) fs::remove_all(entry->path(), ignored);
        } catch (const std::exception&) { // the dataset or the file is damaged; the late files stay
            continue;
        }
    }
}

} // namespace server::store
