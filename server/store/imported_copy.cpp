#include "store/imported_copy.hpp"

#include "store/files/files.hpp"

namespace server::store {
namespace {

namespace fs = std::filesystem;
// The file lies beside the dataset, not in it, so that a copy made by a user is not marked.
constexpr const char* sign = ".imported-by-ciel-serve";
constexpr std::size_t longest_sign = 1 << 16;

} // namespace

void mark_as_copy(const fs::path& dataset, const fs::path& input) {
    replace_file(dataset.parent_path() / sign, bytes_of(input.string() + "\n"));
}

std::string input_of_copy(const fs::path& dataset) {
    std::error_code error;
    const fs::path file = fs::weakly_canonical(dataset, error).parent_path() / sign;
    if (error || !fs::exists(file, error)) return {};
    std::string input = read_text(file, longest_sign);
    if (input.ends_with('\n')) input.pop_back();
    return input;
}

} // namespace server::store
