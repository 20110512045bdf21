#include "wire/batches/mesh_codec.hpp"

#include <meshoptimizer.h>

namespace server::wire {
namespace {

// Called once before the first encoding of any thread, because the library keeps the versions in global variables.
void choose_versions() {
    static const bool chosen = [] {
        meshopt_encodeVertexVersion(0);
        meshopt_encodeIndexVersion(1);
        return true;
    }();
    static_cast<void>(chosen);
}

template <typename Encode>
std::size_t append(std::vector<std::uint8_t>& out, std::size_t bound, const Encode& encode) {
    choose_versions();
    const std::size_t begin = out.size();
    out.resize(begin + bound);
    const std::size_t bytes = encode(out.data() + begin, bound);
    out.resize(begin + bytes);
    return bytes;
}

} // namespace

std::size_t append_vertices(std::vector<std::uint8_t>& out, std::span<const std::uint8_t> vertices,
                            std::size_t stride) {
    const std::size_t count = vertices.size() / stride;
    return append(out, meshopt_encodeVertexBufferBound(count, stride), [&](std::uint8_t* to, std::size_t most) {
        return meshopt_encodeVertexBuffer(to, most, vertices.data(), count, stride);
    });
}

std::size_t append_triangles(std::vector<std::uint8_t>& out, std::span<const ciel::Index> indices,
                             std::size_t vertices) {
    return append(out, meshopt_encodeIndexBufferBound(indices.size(), vertices),
                  [&](std::uint8_t* to, std::size_t most) {
                      return meshopt_encodeIndexBuffer(to, most, indices.data(), indices.size());
                  });
}

std::size_t append_sequence(std::vector<std::uint8_t>& out, std::span<const ciel::Index> indices,
                            std::size_t vertices) {
    return append(out, meshopt_encodeIndexSequenceBound(indices.size(), vertices),
                  [&](std::uint8_t* to, std::size_t most) {
                      return meshopt_encodeIndexSequence(to, most, indices.data(), indices.size());
                  });
}

} // namespace server::wire
