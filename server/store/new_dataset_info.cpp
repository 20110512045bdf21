#include "store/new_dataset_info.hpp"

#include "store/format/checksum.hpp"
#include "store/format/json_reader.hpp"

#include <ctime>
#include <random>

namespace server::store {
namespace {

std::string now_iso8601() {
    const std::time_t now = std::time(nullptr);
    std::tm utc{};
    gmtime_r(&now, &utc);
    char text[32];
    std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc);
    return text;
}

std::string random_id() {
    std::random_device device;
    std::uint32_t words[4];
    for (std::uint32_t& word : words) word = device();
    return checksum(std::as_bytes(std::span(words))).substr(5);
}

} // namespace

DatasetInfo new_dataset_info(const DatasetHeader& header) {
    DatasetInfo info;
    info.id = random_id();
    info.created = now_iso8601();
    info.source = valid_utf8(header.source);
    info.length_units = valid_utf8(header.length_units);
    info.input_vertices = header.input_vertices;
    info.input_edges = header.input_edges;
    info.input_cells = header.input_cells;
    for (const std::string& note : header.notes) info.notes.push_back(valid_utf8(note));
    return info;
}

} // namespace server::store
