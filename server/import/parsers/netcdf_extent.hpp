// Computes the length of a classic netCDF file from its header. With this length, the import detects a file that was
// cut off. The netCDF library would read zeros after the end of such a file.
// Format: NetCDF Classic Format Specification (CDF-1, CDF-2, CDF-5).
#pragma once

#include <cstdint>
#include <istream>
#include <optional>
#include <string>

namespace server::importer {

struct NetcdfExtent {
    std::uint64_t fixed_end = 0;    // file offset after the header and all variables without records
    std::uint64_t record_begin = 0; // file offset of the first record
    std::uint64_t record_bytes = 0; // size in bytes of one record; 0: no variable has records
    std::uint64_t last_bytes = 0;   // size in bytes of the last record, which may lack its padding
    std::uint64_t records = 0;      // number of records that the header declares

    // Returns the number of records that lie completely within the first `bytes` bytes of the file.
    [[nodiscard]] std::uint64_t records_within(std::uint64_t bytes) const;
};

// Returns nullopt for a file in another format, such as HDF5. Throws Error if the header is damaged or cut off.
[[nodiscard]] std::optional<NetcdfExtent> read_netcdf_extent(std::istream& file, const std::string& name);

} // namespace server::importer
