// Fuzzes read_frame_header: bytes are refused with an Error, or the header is written back identically.
#include "wire/frame_header.hpp"
#include "ciel/types.hpp"

#include <cstdlib>
#include <cstring>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace server::wire;
    try {
        const FrameHeader header = read_frame_header({data, size});
        std::array<std::uint8_t, frame_header_bytes> again{};
        write_frame_header(header, again);
        if (std::memcmp(again.data(), data, 72) != 0) std::abort(); // the reserved bytes after these 72 are not kept
    } catch (const ciel::Error&) {
        return 0;
    }
    return 0;
}
