// Index files: small texts that name the files of a time series. VTK 9.1 reads none of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

struct IndexEntry {
    double time = 0;
    std::string part; // name of the part, or empty; entries of one time are parts of one mesh
    std::string file; // path as written, relative to the index file
};

// Parses ParaView's PVD: <VTKFile type="Collection"><Collection><DataSet timestep= part= name= file=/>...
// Returns entries sorted by time; those of one time stay in file order. Throws Error naming `name`.
[[nodiscard]] std::vector<IndexEntry> parse_pvd(std::string_view text, const std::string& name);

// Parses ParaView's file series: {"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]}.
// Returns entries sorted by time. Throws Error naming `name`.
[[nodiscard]] std::vector<IndexEntry> parse_series(std::string_view text, const std::string& name);

} // namespace ciel::importer
