// Computes the length of a classic netCDF file from its header, to detect files that were cut off: the netCDF library
// reads zeros beyond their end. Format: NetCDF Classic Format Specification (CDF-1, CDF-2, CDF-5).
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace ciel::importer {

struct NetcdfExtent {
    std::uint64_t fixed_end = 0;    // file offset after the header and all variables without records
    std::uint64_t record_begin = 0; // file offset of the first record
    std::uint64_t record_bytes = 0; // size of one record; 0: no variable has records
    std::uint64_t last_bytes = 0;   // size of the last record, which may lack its padding
    std::uint64_t records = 0;      // number of records that the header declares

    // Returns how many records lie completely within the first `bytes` bytes of the file.
    [[nodiscard]] std::uint64_t records_within(std::uint64_t bytes) const;
};

// Returns nothing for files in other formats, such as HDF5. Throws Error naming `name` if the header is damaged or cut
// off.
[[nodiscard]] std::optional<NetcdfExtent> read_netcdf_extent(std::istream& file, const std::string& name);

} // namespace ciel::importer
