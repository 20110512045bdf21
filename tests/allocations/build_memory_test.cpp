// Memory of the tasks that build a Topology: scratch memory must not grow with the size of the mesh.
#include "allocations/counted_new.hpp"
#include "ciel/topology.hpp"
#include "support/meshes.hpp"
#include "support/thread_count.hpp"
#include "support/views.hpp"

#include <gtest/gtest.h>

namespace ciel::test {
namespace {

// Number of allocations as long as an array over all vertices. The scratch memory of these blocks is far smaller.
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
