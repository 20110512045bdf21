// Fuzzes the replacement of NaN and infinity in legacy VTK files. Afterwards none is found, and a file without any is
// unchanged.
#include "import/parsers/legacy_vtk_numbers.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string content(reinterpret_cast<const char*>(data), size);
    std::istringstream looked_at(content), read(content);
    const bool holds_some = server::importer::holds_no_numbers(looked_at);
    const std::string readable = server::importer::with_stand_ins(read);
    if (!holds_some && readable != content) std::abort();
    std::istringstream again(readable);
    if (server::importer::holds_no_numbers(again)) std::abort();
    return 0;
}
