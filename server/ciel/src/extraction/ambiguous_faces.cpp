// Counts the ambiguous faces, on which the points of a surface could be joined in more than one way (paper, section 4).
#include "ciel/field.hpp"
#include "ciel/parallel.hpp"
#include "mesh/loop.hpp"

#include <atomic>
#include <cmath>

namespace ciel {

namespace {

bool is_ambiguous(std::span<const Index> loop, ValuesView values) {
    const auto above = [&](Index a, Index b) { return values[a] != values[b] ? values[a] > values[b] : a > b; };
    int maxima = 0;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index here = loop[i], before = loop[i == 0 ? loop.size() - 1 : i - 1],
                    after = loop[i + 1 == loop.size() ? 0 : i + 1];
        if (!std::isfinite(values[here])) return false;
        if (above(here, before) && above(here, after)) ++maxima;
    }
    return maxima > 1;
}

} // namespace

std::uint64_t count_ambiguous_faces(const FaceMeshView& mesh, ValuesView values) {
    if (values.size() != mesh.vertex_count()) fail("a field must hold one value per vertex");
    std::atomic<std::uint64_t> count{0};
    parallel_for(mesh.face_count(), 16384, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> loop;
        std::uint64_t found = 0;
        for (std::size_t f = begin; f < end; ++f) {
            loop.clear();
            append_without_repeats(mesh.loop(static_cast<Index>(f)), loop);
            found += is_ambiguous(loop, values) ? 1 : 0;
        }
        count += found;
    });
    return count;
}

} // namespace ciel
