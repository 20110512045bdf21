// Fuzzes the parser of upload messages: bytes are refused with an Error, or the piece fills the message after its
// header.
#include "wire/upload_piece.hpp"
#include "ciel/types.hpp"

#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace server::wire;
    try {
        const UploadPiece piece = read_upload_piece({data, size});
        if (piece.bytes.size() + upload_header_bytes != size) std::abort();
        if (!piece.bytes.empty() && piece.bytes.data() != data + upload_header_bytes) std::abort();
        unsigned sum = 0;
        for (const std::uint8_t byte : piece.bytes) sum += byte;
        if (sum > 255 * piece.bytes.size()) std::abort(); // reads all bytes of the piece
    } catch (const ciel::Error&) {
        return 0;
    }
    return 0;
}
