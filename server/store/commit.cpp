#include "store/commit.hpp"

#include "store/files/files.hpp"
#include "store/format/layout.hpp"
#include "store/format/step_table.hpp"

#include <exception>
#include <utility>

namespace server::store {
namespace {

constexpr std::size_t most_steps_in_marker = 64;
constexpr std::size_t most_id_bytes = 32; // size of the id in the head of a binary file (file_head.hpp)

} // namespace

void Commit::put(const Marker& marker) const {
    const std::string text = to_text(marker);
    const auto file = directory / layout::commit_marker;
    is_appending ? replace_file(file, bytes_of(text)) : write_file(file, bytes_of(text));
}

bool Commit::move_steps_to_table(Marker& marker) const {
    if (marker.steps.size() <= most_steps_in_marker || dataset_id.size() > most_id_bytes) return false;
    Marker next{marker.meshes, append_to_table(directory, marker.table, dataset_id, marker.steps), {}};
    put(next);
    marker = std::move(next);
    return true;
}

void Commit::read_table_again(Marker& marker) const noexcept {
    try {
        const auto file = directory / layout::commit_marker;
        Marker now = parse_marker(read_text(file, layout::marker_bytes), file);
        if (now.table.steps > marker.table.steps) marker = std::move(now);
    } catch (const std::exception&) { // `marker` is then unchanged
    }
}

} // namespace server::store
