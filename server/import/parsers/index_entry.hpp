// Index files: small texts that name the files of a time series. VTK 9.1 reads none of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ciel::importer {

struct IndexEntry {
    double time = 0;
    std::string part; // several entries of one time are parts of one mesh; empty when not named
    std::string file; // as written: relative to the index file
};

// ParaView Data: <VTKFile type="Collection"><Collection><DataSet timestep= part= name= file=/>...
// Sorted by time, entries of one time in file order. Throws Error naming `name`.
[[nodiscard]] std::vector<IndexEntry> parse_pvd(std::string_view text, const std::string& name);

// ParaView's file series: {"file-series-version": "1.0", "files": [{"name": ..., "time": ...}, ...]}.
// Sorted by time. Throws Error naming `name`.
[[nodiscard]] std::vector<IndexEntry> parse_series(std::string_view text, const std::string& name);

} // namespace ciel::importer
