// Index files: small text files that list the data files of a time series. VTK 9.1 has no reader for index files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace server::importer {

struct IndexEntry {
    double time = 0;
    std::string piece; // name of the piece, may be empty; entries with equal times are pieces of one mesh
    std::string file;  // path of the data file as written, relative to the index file
};

// Parses ParaView's PVD: <VTKFile type="Collection"><Collection><DataSet timestep= part= name= file=/>...
// Returns the entries sorted by time. Entries with equal times stay in file order. Error texts start with `name`.
[[nodiscard]] std::vector<IndexEntry> parse_pvd(std::string_view text, const std::string& name);

// Parses ParaView's file series: {"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]}.
// Returns the entries sorted by time. Error texts start with `name`.
[[nodiscard]] std::vector<IndexEntry> parse_series(std::string_view text, const std::string& name);

} // namespace server::importer
