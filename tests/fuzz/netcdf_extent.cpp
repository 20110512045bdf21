// Fuzzes netCDF headers: each is read or refused, and a longer file never has fewer records.
#include "import/parsers/netcdf_extent.hpp"
#include "ciel/types.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::istringstream file(std::string(reinterpret_cast<const char*>(data), size));
    try {
        const auto extent = server::importer::read_netcdf_extent(file, "x");
        if (!extent) return 0;
        std::uint64_t before = 0;
        for (std::uint64_t bytes = 1; bytes < std::uint64_t{1} << 40U; bytes *= 2) {
            const std::uint64_t records = extent->records_within(bytes);
            if (records < before || records > extent->records) std::abort();
            before = records;
        }
    } catch (const ciel::Error&) { // the parser may refuse the input
    }
    return 0;
}
