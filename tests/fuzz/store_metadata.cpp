// Fuzzes the store's text documents and .npy files; the first byte selects the parser. Accepted content is written,
// read again and must be equal.
#include "store/format/attributes.hpp"
#include "store/format/marker.hpp"
#include "store/format/npy.hpp"
#include "store/format/zarr_array.hpp"

#include <cstdlib>
#include <string>

namespace {

using namespace server::store;

const std::filesystem::path file = "fuzzed";

template <typename Parse, typename Print>
void round_trip(std::string_view text, const Parse& parse, const Print& print) {
    const std::string once = print(parse(text, file));
    if (print(parse(once, file)) != once) std::abort();
}

template <typename T>
std::string print(const T& value) {
    return to_text(value);
}

void run(std::uint8_t which, std::string_view text) {
    switch (which % 6) {
    case 0:
        return round_trip(text, parse_root_attributes, root_attributes_text);
    case 1:
        return round_trip(text, parse_mesh_attributes, print<MeshAttributes>);
    case 2:
        return round_trip(text, parse_array_attributes, print<ArrayInfo>);
    case 3:
        return round_trip(text, parse_marker, print<Marker>);
    case 4: {
        const ZarrArray array = parse_zarr_array(text, file);
        (void)array.chunk_bytes(file);
        return round_trip(text, parse_zarr_array, print<ZarrArray>);
    }
    default: {
        const NpyArray array = parse_npy(std::as_bytes(std::span(text.data(), text.size())), file);
        std::size_t count = 1;
        for (const std::size_t extent : array.shape) count *= extent;
        if (count != array.values.size()) std::abort();
    }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    try {
        run(data[0], {reinterpret_cast<const char*>(data + 1), size - 1});
    } catch (const ciel::Error&) { // only Error is a valid refusal
    }
    return 0;
}
