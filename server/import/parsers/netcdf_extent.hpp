// How long a classic netCDF file is by its own header. The library reads zeros beyond the end of a file that was cut
// off. Format: NetCDF Classic Format Specification (CDF-1, CDF-2, CDF-5).
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace ciel::importer {

struct NetcdfExtent {
    std::uint64_t fixed_end = 0;    // of the header and of all variables without a record
    std::uint64_t record_begin = 0; // of the first of `records`
    std::uint64_t record_bytes = 0; // of each; 0: no variable has one
    std::uint64_t last_bytes = 0;   // of the last one, which may lack its padding
    std::uint64_t records = 0;      // as declared

    // Of them those that lie within the first `bytes` of the file.
    [[nodiscard]] std::uint64_t records_within(std::uint64_t bytes) const;
};

// Nothing where the file is none of these: HDF5, for one. Throws Error naming `name` where the header is damaged, or
// ends before it is complete.
[[nodiscard]] std::optional<NetcdfExtent> read_netcdf_extent(std::istream& file, const std::string& name);

} // namespace ciel::importer
