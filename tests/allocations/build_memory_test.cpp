// What the building of the structure takes for each of its tasks: not more the larger the mesh is.
#include "allocations/counted_new.hpp"
#include "ciel/topology.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

// Arrays as long as the mesh has vertices, in blocks whose scratch is far smaller.
std::size_t long_arrays(const FaceMeshView& mesh, unsigned threads) {
    const ThreadCount count(threads);
    const LargeAllocations large(std::size_t{4} * mesh.vertex_count());
    const Topology topology(mesh, {64});
    return LargeAllocations::count();
}

TEST(BuildMemory, NoTaskHasATableOfAllVertices) {
    for (const Polyhedra& input : {hexahedra({{24, 24, 24}}), hexagonal_prisms(20, 20, 20)}) {
        const Assembled assembled = assemble(view(input));
        const FaceMeshView mesh = assembled.mesh.view();
        EXPECT_EQ(long_arrays(mesh, 16), long_arrays(mesh, 1)) << "more tasks, more tables";
    }
}

} // namespace
} // namespace ciel::test
